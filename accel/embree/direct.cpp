#include "accel/embree/direct.h"

#include "accel/embree/accel.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace embree {
namespace {

using Clock = std::chrono::steady_clock;

template <class Work>
double seconds(Work&& work) {
    const Clock::time_point start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> samples) {
    const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    std::nth_element(samples.begin(), middle, samples.end());
    return *middle;
}

/// The seconds of one side, block by block: a sample per pass.
using Times = std::vector<std::vector<double>>;

std::vector<double> medians(const Times& times) {
    std::vector<double> each;
    for (const std::vector<double>& samples : times) each.push_back(median(samples));
    return each;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Ratio of the sums over all blocks, with the interval of a bootstrap over the blocks.
RatioInterval ratio_of_sums(const std::vector<double>& above, const std::vector<double>& below) {
    constexpr int resamples = 400;
    std::mt19937 random(1);
    std::vector<double> ratios;
    for (int i = 0; i < resamples; ++i) {
        double sum_above = 0, sum_below = 0;
        for (std::size_t j = 0; j < above.size(); ++j) {
            const std::size_t block = random() % above.size();
            sum_above += above[block];
            sum_below += below[block];
        }
        ratios.push_back(sum_above / sum_below);
    }
    std::sort(ratios.begin(), ratios.end());
    constexpr std::size_t tail = resamples / 40;  // 2.5 %
    return {sum(above) / sum(below), ratios[tail], ratios[resamples - 1 - tail]};
}

/// Rays in the layout of one of Embree's paths, as a program of its own would keep them.
template <Query Q>
class NativeRays {
public:
    NativeRays(const Scene& scene, Path path) : scene_(scene), path_(path), ends_(scene) {
        valid_.fill(-1);
    }

    /// Untimed: records are used up by tracing.
    void refill(std::span<const Ray> rays) {
        if (path_.kernel == Kernel::packet) {
            packets_.resize(rays.size() / width);
            for (std::size_t i = 0; i < packets_.size(); ++i) {
                prepare<packet_width>(packets_[i]);
                load<packet_width>(&rays[i * width], ends_, packets_[i]);
            }
        } else {
            records_.resize(rays.size());
            for (std::size_t i = 0; i < rays.size(); ++i) {
                prepare(records_[i]);
                load(rays[i], ends_, records_[i]);
            }
        }
    }
    void trace() {
        Asker asker(scene_.handle(), path_.coherence);
        if (path_.kernel == Kernel::packet) {
            for (auto& packet : packets_) asker.ask(valid_.data(), &packet);
        } else if (path_.kernel == Kernel::single) {
            for (auto& record : records_) asker.ask(&record);
        } else {
            asker.ask_stream(records_.data(), records_.size());
        }
    }
    void answer(std::vector<Answer<Q>>& answers) const {
        if (path_.kernel != Kernel::packet)
            return embree::answer(scene_, std::span<const Record<Q>>(records_), answers.data());
        for (std::size_t i = 0; i < packets_.size(); ++i)
            embree::answer<packet_width>(scene_, packets_[i], &answers[i * width]);
    }

private:
    static constexpr auto width = static_cast<std::size_t>(packet_width);

    const Scene& scene_;
    Path path_;
    Ends ends_;
    alignas(64) std::array<int, width> valid_;
    std::vector<Record<Q>> records_;
    std::vector<Packet<Q, packet_width>> packets_;
};

void ask(Session& session, const RayBatch& batch, std::vector<Hit>& hits) {
    session.closest(batch, hits);
}
void ask(Session& session, const RayBatch& batch, std::vector<std::uint8_t>& occluded) {
    session.occluded(batch, occluded);
}

/// Both sides of one path and question. Each pass goes over all blocks once, as a program would: a
/// side that traced the same block twice in a row would meet branch predictors that know it.
template <Query Q>
class Sides {
public:
    Sides(const Scene& scene, Choice choice, const RayBatch& all, std::size_t block)
        : native_(scene, path(choice, Q, all.kind)),
          session_(open_session(scene, choice)),
          all_(all),
          block_(block),
          rays_(block),
          answers_(block) {}

    std::size_t blocks() const { return all_.rays.size() / block_; }
    std::size_t differences() const { return differences_; }

    void pass_directly(Times& times) {
        for (std::size_t i = 0; i < blocks(); ++i) {
            native_.refill(rays(i));
            times[i].push_back(seconds([&] { native_.trace(); }));
        }
    }
    void pass_through_adaptor(Times& times) {
        for (std::size_t i = 0; i < blocks(); ++i) {
            // Into the caches, untimed, as refilling brings the other side's.
            std::copy(rays(i).begin(), rays(i).end(), rays_.begin());
            const RayBatch batch{all_.kind, all_.depth, rays_, {}};
            times[i].push_back(seconds([&] { ask(*session_, batch, answers_); }));
        }
    }
    void compare() {
        for (std::size_t i = 0; i < blocks(); ++i) {
            native_.refill(rays(i));
            native_.trace();
            ask(*session_, {all_.kind, all_.depth, rays(i), {}}, answers_);
            std::vector<Answer<Q>> direct(block_);
            native_.answer(direct);
            for (std::size_t j = 0; j < block_; ++j) differences_ += !(direct[j] == answers_[j]);
        }
    }

private:
    std::span<const Ray> rays(std::size_t i) const { return all_.rays.subspan(i * block_, block_); }

    NativeRays<Q> native_;
    std::unique_ptr<Session> session_;
    RayBatch all_;
    std::size_t block_;
    std::vector<Ray> rays_;
    std::vector<Answer<Q>> answers_;
    std::size_t differences_ = 0;
};

struct Plan {
    Choice choice;
    RayBatch all;
    std::size_t block;
    int repetitions;
};

template <Query Q>
DirectRow measure(const Scene& scene, const Plan& plan) {
    Sides<Q> sides(scene, plan.choice, plan.all, plan.block);
    sides.compare();  // also brings the scene into the caches
    Times direct(sides.blocks()), adaptor(sides.blocks());
    for (int i = 0; i < plan.repetitions; ++i) {
        sides.pass_directly(direct);
        sides.pass_through_adaptor(adaptor);
        sides.pass_through_adaptor(adaptor);
        sides.pass_directly(direct);
    }
    const std::vector<double> direct_seconds = medians(direct), adaptor_seconds = medians(adaptor);
    const double mrays = 1e-6 * static_cast<double>(plan.block * sides.blocks());
    constexpr std::string_view names[] = {"auto", "single", "packet", "stream"};
    return {names[static_cast<std::size_t>(plan.choice)],
            Q,
            plan.all.kind,
            mrays / sum(direct_seconds),
            mrays / sum(adaptor_seconds),
            ratio_of_sums(direct_seconds, adaptor_seconds),
            sides.blocks(),
            sides.differences()};
}

}  // namespace
}  // namespace embree

std::vector<DirectRow> measure_direct(const Geometry& geometry, RayKind kind,
                                      std::span<const Ray> rays, int repetitions,
                                      std::size_t block) {
    using namespace embree;
    std::vector<Ray> plain;
    for (const Ray& ray : rays)
        if (answerable(ray) && all_plain(std::span(&ray, 1))) plain.push_back(ray);
    constexpr auto width = static_cast<std::size_t>(packet_width);
    block = std::min({block, max_batch, plain.size()}) / width * width;
    std::vector<DirectRow> rows;
    if (block == 0 || repetitions < 1) return rows;
    const Scene scene(geometry, RTC_BUILD_QUALITY_MEDIUM);
    for (const Choice choice : {Choice::single, Choice::packet, Choice::stream}) {
        if (choice == Choice::stream && !has_streams) continue;
        const Plan plan{choice, {kind, 1, plain, {}}, block, repetitions};
        rows.push_back(measure<Query::closest>(scene, plan));
        rows.push_back(measure<Query::occluded>(scene, plan));
    }
    return rows;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
