#include "accel/embree/lane.h"

namespace rayshoot::inline RAYSHOOT_ISA::embree {
namespace {

/// Rays that are converted, traced and converted back at once. So many stay in the first-level
/// cache with their records and hits ...
constexpr std::size_t small_block = 256;
/// ... but incoherent rays of an occluded stream are sorted by octant inside Embree, which longer
/// streams make worth more than the cache (1024 against 256 rays: 3 to 10 % faster).
constexpr std::size_t large_block = 1024;

template <Query Q>
std::size_t block(Path path) {
    const bool sorted = Q == Query::occluded && path.kernel == Kernel::stream &&
                        path.coherence == Coherence::incoherent;
    return sorted ? large_block : small_block;
}

/// Never hits: its interval is empty.
constexpr Ray inert{vec3{0}, 1, vec3{0, 0, 1}, 0.5f, 0};

}  // namespace

Lane::Lane(const Scene& scene)
    : scene_(scene),
      ends_(scene),
      clean_(large_block),
      closest_(small_block),
      occluded_(large_block) {
    for (RTCRayHit& record : closest_) prepare(record);
    for (RTCRay& ray : occluded_) prepare(ray);
}

std::size_t Lane::bytes() const {
    return clean_.size() * sizeof(Ray) + closest_.size() * sizeof(RTCRayHit) +
           occluded_.size() * sizeof(RTCRay);
}

template <>
std::vector<RTCRayHit>& Lane::records<Query::closest>() {
    return closest_;
}
template <>
std::vector<RTCRay>& Lane::records<Query::occluded>() {
    return occluded_;
}

template <Query Q>
void Lane::answer(Path path, std::span<const Ray> rays, Answer<Q>* answers) {
    while (!rays.empty()) {
        const std::size_t count = std::min(rays.size(), block<Q>(path));
        if (all_plain(rays.first(count))) [[likely]]
            answer_plain<Q>(path, rays.first(count), answers);
        else answer_mixed<Q>(path, rays.first(count), answers);
        rays = rays.subspan(count);
        answers += count;
    }
}

template <Query Q>
void Lane::answer_plain(Path path, std::span<const Ray> rays, Answer<Q>* answers) {
    Asker asker(scene_.handle(), path.coherence);
    if (path.kernel == Kernel::packet) answer_packets<Q>(asker, rays, answers);
    else answer_records<Q>(asker, path.kernel, rays, answers);
}

template <Query Q>
void Lane::answer_mixed(Path path, std::span<const Ray> rays, Answer<Q>* answers) {
    const auto plain = [](const Ray& ray) { return all_plain(std::span(&ray, 1)); };
    for (std::size_t i = 0; i < rays.size(); ++i) clean_[i] = plain(rays[i]) ? rays[i] : inert;
    answer_plain<Q>(path, std::span(clean_).first(rays.size()), answers);
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (!plain(rays[i])) answers[i] = answer_alone<Q>(rays[i]);
}

/// Embree does not look behind the origin: where t_min < 0, the origin is moved back as far as the
/// scene reaches.
template <Query Q>
Answer<Q> Lane::answer_alone(const Ray& ray) {
    if (!answerable(ray)) return {};
    const Interval inside = clip(SlabRay(ray.origin, ray.direction), scene_.geometry().bounds());
    if (inside.empty()) return {};
    constexpr float slack = 1e-3f;  // far above rounding; tracing a little more costs nothing
    const float before = inside.entry - slack * (std::abs(inside.entry) + std::abs(inside.exit));
    const float start = std::min(0.0f, std::max(ray.t_min, before));
    const Ray moved{along(ray.origin, start, ray.direction), std::max(0.0f, ray.t_min - start),
                    ray.direction, ray.t_max - start, shutter_time(ray.time)};
    if (!answerable(moved)) return {};
    Answer<Q> answer{};
    Asker asker(scene_.handle(), Coherence::incoherent);
    answer_records<Q>(asker, Kernel::single, std::span(&moved, 1), &answer);
    if constexpr (Q == Query::closest) {
        answer.t += start;
        if (!(ray.t_min < answer.t && answer.t < ray.t_max)) return {};
    }
    return answer;
}

/// Converted block by block also where Embree is asked ray by ray: it loads 16 bytes of a record at
/// once, which waits for the four stores that have just filled them.
template <Query Q>
void Lane::answer_records(Asker& asker, Kernel kernel, std::span<const Ray> rays,
                          Answer<Q>* answers) {
    Record<Q>* records = this->records<Q>().data();
    for (std::size_t i = 0; i < rays.size(); ++i) load(rays[i], ends_, records[i]);
    if (kernel == Kernel::stream) {
        asker.ask_stream(records, rays.size());
    } else {
        for (std::size_t i = 0; i < rays.size(); ++i) asker.ask(&records[i]);
    }
    embree::answer(scene_, std::span<const Record<Q>>(records, rays.size()), answers);
}

/// Several packets at a time, for the same reason: Embree loads whole registers of a packet.
template <Query Q>
void Lane::answer_packets(Asker& asker, std::span<const Ray> rays, Answer<Q>* answers) {
    constexpr auto width = static_cast<std::size_t>(packet_width);
    constexpr std::size_t most = 4;  // packets; more bring nothing
    std::array<Packet<Q, packet_width>, most> packets;
    for (auto& packet : packets) prepare<packet_width>(packet);
    alignas(64) std::array<int, width> valid;
    valid.fill(-1);
    const auto answer = [&](const Ray* from, std::size_t count, Answer<Q>* to) {
        for (std::size_t i = 0; i < count; ++i)
            load<packet_width>(from + i * width, ends_, packets[i]);
        for (std::size_t i = 0; i < count; ++i) asker.ask(valid.data(), &packets[i]);
        for (std::size_t i = 0; i < count; ++i)
            embree::answer<packet_width>(scene_, packets[i], to + i * width);
    };
    const std::size_t whole = rays.size() / width;
    for (std::size_t i = 0; i < whole; i += most)
        answer(&rays[i * width], std::min(most, whole - i), answers + i * width);
    const std::size_t rest = rays.size() % width;
    if (rest == 0) return;
    std::array<Ray, width> last_rays;
    std::array<Answer<Q>, width> last_answers;
    last_rays.fill(inert);
    std::copy_n(rays.end() - static_cast<std::ptrdiff_t>(rest), rest, last_rays.begin());
    std::fill(valid.begin() + static_cast<std::ptrdiff_t>(rest), valid.end(), 0);
    answer(last_rays.data(), 1, last_answers.data());
    std::copy_n(last_answers.begin(), rest, answers + whole * width);
}

template void Lane::answer<Query::closest>(Path, std::span<const Ray>, Hit*);
template void Lane::answer<Query::occluded>(Path, std::span<const Ray>, std::uint8_t*);

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
