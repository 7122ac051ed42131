#pragma once

#include "accel/bvh8/flight.h"

/// What the beam round a packet has still to visit.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A child of a node that a beam meets.
struct Halt {
    std::uint32_t node, place;
    float entry;  ///< where the beam enters the child
};

/// A stack of them, of nodes with so many children.
template <std::size_t Width>
class Halts {
public:
    void clear() { size_ = 0; }
    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    /// 0: the first one that was pushed.
    Halt operator[](std::size_t i) const {
        return {children_[i] / width, children_[i] % width, entries_[i]};
    }
    Halt top() const { return (*this)[size_ - 1]; }
    void drop() { --size_; }
    /// The children of a node at some places, the nearest one on top, the others in
    /// any order. Without a branch: how many there are cannot be foretold.
    void push(std::uint32_t node, Places<Width> met, simd::Floats<Width> entries);

private:
    static constexpr std::uint32_t width = Width;
    /// A node leaves all children but one behind at most; all are written at once.
    static constexpr std::size_t most = (width - 1) * Stack::deepest + width;

    std::array<std::uint32_t, most> children_;  ///< node * width + place
    std::array<float, most> entries_;
    std::size_t size_ = 0;
};

template <std::size_t Width>
inline void Halts<Width>::push(std::uint32_t node, Places<Width> met, simd::Floats<Width> entries) {
    using namespace simd;
    constexpr auto tag = floats<width>;
    constexpr auto word = words<width>;
    const std::uint32_t places = bits(tag, met), nearest = nearest_of(met, entries),
                        others = places & ~(1u << nearest);
    const auto children = hn::Add(hn::Set(word, node * width), hn::Iota(word, 0));
    hn::StoreU(compress(children, others), word, &children_[size_]);
    hn::StoreU(compress(entries, others), tag, &entries_[size_]);
    alignas(32) std::array<float, width> each;
    hn::Store(entries, tag, each.data());
    const std::size_t last = size_ + static_cast<std::size_t>(std::popcount(others));
    children_[last] = node * width + nearest;
    entries_[last] = each[nearest];
    size_ += static_cast<std::size_t>(std::popcount(places));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
