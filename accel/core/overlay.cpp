#include "accel/core/overlay.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// The rays that one member passes on to the next, gathered, with the place of each in the batch.
struct Remainder {
    std::vector<Ray> rays;
    std::vector<Source> source;
    std::vector<std::uint32_t> index_of;
    std::vector<Hit> hits;
    std::vector<std::uint8_t> bits;

    template <class Answer>
    std::span<Answer> answers() {
        if constexpr (std::is_same_v<Answer, Hit>) return hits;
        else return bits;
    }
};

template <Query Q, class Answer>
std::span<const std::uint32_t> ask(Session& session, const RayBatch& batch,
                                   std::span<Answer> answers) {
    if constexpr (Q == Query::closest) return session.closest(batch, answers);
    else return session.occluded(batch, answers);
}

class OverlaySession final : public Session {
public:
    OverlaySession(std::span<const std::unique_ptr<Accel>> accels, Mode mode) : accels_(accels) {
        for (const auto& accel : accels) members_.push_back(accel->open(mode));
    }

    std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) override {
        return answer<Query::closest>(batch, hits);
    }
    std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                            std::span<std::uint8_t> occluded) override {
        return answer<Query::occluded>(batch, occluded);
    }
    const Counters* counters(RayKind kind) const override {
        const bool all_count =
            std::all_of(members_.begin(), members_.end(),
                        [&](const auto& member) { return member->counters(kind) != nullptr; });
        return all_count ? &sums_[static_cast<std::size_t>(kind)] : nullptr;
    }
    std::span<const std::unique_ptr<Session>> members() const override { return members_; }
    std::size_t bytes() const override {
        std::size_t total = 0;
        for (const auto& member : members_) total += member->bytes();
        return total;
    }

private:
    /// Members past the front see only what is left: the whole batch untouched as long as nothing
    /// was answered, gathered rays after that.
    template <Query Q, class Answer>
    std::span<const std::uint32_t> answer(const RayBatch& batch, std::span<Answer> answers) {
        std::size_t member = 0;
        while (member + 1 < members_.size() && !accels_[member]->serves(Q, batch.kind)) ++member;
        std::span<const std::uint32_t> left = ask<Q>(*members_[member], batch, answers);
        for (++member; member < members_.size() && !left.empty(); ++member) {
            if (!accels_[member]->serves(Q, batch.kind)) continue;
            if (left.size() == batch.rays.size()) {
                left = ask<Q>(*members_[member], batch, answers);
            } else {
                gather(batch, left);
                left = scatter(ask<Q>(*members_[member], gathered(batch), rest_.answers<Answer>()),
                               answers);
            }
        }
        add_up(batch.kind, left.size());
        return left;
    }

    void add_up(RayKind kind, std::size_t declined_by_all) {
        Counters& sum = sums_[static_cast<std::size_t>(kind)];
        const std::uint64_t declined = sum[Event::declined] + declined_by_all;
        sum = {};
        for (const auto& member : members_)
            if (const Counters* part = member->counters(kind)) sum += *part;
        sum[Event::declined] = declined;
    }

    void gather(const RayBatch& batch, std::span<const std::uint32_t> left) {
        // `left` may lie in index_of's successor storage: take a copy before anything is cleared.
        std::vector<std::uint32_t> index_of(left.begin(), left.end());
        rest_.rays.clear();
        rest_.source.clear();
        for (const std::uint32_t i : index_of) {
            rest_.rays.push_back(batch.rays[i]);
            if (!batch.source.empty()) rest_.source.push_back(batch.source[i]);
        }
        rest_.index_of = std::move(index_of);
        rest_.hits.resize(rest_.rays.size());
        rest_.bits.resize(rest_.rays.size());
    }

    RayBatch gathered(const RayBatch& batch) const {
        return {batch.kind, batch.depth, rest_.rays, rest_.source};
    }

    /// Puts the answers of the gathered rays in their places; returns what is still declined.
    template <class Answer>
    std::span<const std::uint32_t> scatter(std::span<const std::uint32_t> declined,
                                           std::span<Answer> answers) {
        const std::span<Answer> from = rest_.answers<Answer>();
        for (std::size_t i = 0; i < from.size(); ++i) answers[rest_.index_of[i]] = from[i];
        declined_.clear();
        for (const std::uint32_t i : declined) declined_.push_back(rest_.index_of[i]);
        return declined_;
    }

    std::span<const std::unique_ptr<Accel>> accels_;
    std::vector<std::unique_ptr<Session>> members_;
    Remainder rest_;
    std::vector<std::uint32_t> declined_;
    std::array<Counters, ray_kinds> sums_{};
};

class OverlayAccel final : public Accel {
public:
    explicit OverlayAccel(std::vector<std::unique_ptr<Accel>> members)
        : members_(std::move(members)) {
        for (const auto& member : members_) spec_ += (spec_.empty() ? "" : "+") + member->spec();
    }

    std::unique_ptr<Session> open(Mode mode) const override {
        return std::make_unique<OverlaySession>(members_, mode);
    }
    Footprint footprint() const override;
    bool serves(Query, RayKind) const override { return true; }
    const std::string& spec() const override { return spec_; }
    bool complete() const override { return true; }
    bool remembers() const override {
        return std::any_of(members_.begin(), members_.end(),
                           [](const auto& member) { return member->remembers(); });
    }
    std::span<const std::unique_ptr<Accel>> members() const override { return members_; }

private:
    std::vector<std::unique_ptr<Accel>> members_;
    std::string spec_;
};

/// Only bytes add up over members; nodes and leaves of different structures do not.
Footprint OverlayAccel::footprint() const {
    Footprint sum{.bytes = 0};
    for (const auto& member : members_) {
        const auto bytes = member->footprint().bytes;
        sum.bytes = bytes && sum.bytes ? std::optional(*sum.bytes + *bytes) : std::nullopt;
    }
    return sum;
}

}  // namespace

std::unique_ptr<Accel> overlay(std::vector<std::unique_ptr<Accel>> members) {
    return std::make_unique<OverlayAccel>(std::move(members));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
