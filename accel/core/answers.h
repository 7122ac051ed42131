#pragma once

#include "accel/core/counters.h"
#include "accel/core/ray.h"

#include <span>
#include <type_traits>
#include <vector>

/// Where the answers of a batch go.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q>
using Answer = std::conditional_t<Q == Query::closest, Hit, std::uint8_t>;

/// The answer that a finished search stands for.
template <Query Q>
inline Answer<Q> conclude(const Hit& hit) {
    if constexpr (Q == Query::occluded) return hit.primitive != no_primitive;
    else return hit.primitive != no_primitive ? hit : Hit{};
}

/// What a batch-answering structure writes to: store(i, hit) or decline(i), once for every ray,
/// declines ascending. `hit` starts from nothing_yet(ray).
template <Query Q>
class Answers {
public:
    /// `index_of`: where rays of a compacted batch stood, or empty.
    Answers(std::span<Answer<Q>> answers, std::vector<std::uint32_t>& declined,
            std::span<const std::uint32_t> index_of)
        : answers_(answers), declined_(declined), index_of_(index_of) {}

    void store(std::size_t i, const Hit& hit) {
        hits_ += hit.primitive != no_primitive;
        answers_[index(i)] = conclude<Q>(hit);
    }
    void decline(std::size_t i) { declined_.push_back(static_cast<std::uint32_t>(index(i))); }
    std::uint64_t hits() const { return hits_; }

private:
    std::size_t index(std::size_t i) const { return index_of_.empty() ? i : index_of_[i]; }

    std::span<Answer<Q>> answers_;
    std::vector<std::uint32_t>& declined_;
    std::span<const std::uint32_t> index_of_;
    std::uint64_t hits_ = 0;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
