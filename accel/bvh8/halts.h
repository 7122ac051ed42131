#pragma once

#include "accel/bvh8/flight.h"

/// What a packet has still to visit.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A child that a beam meets.
struct Halt {
    WideChild child = WideChild::none();
    const WideNode* parent = nullptr;  ///< has its bounds; null for the root
    std::uint32_t place = 0;           ///< of the child in it
    float entry = -infinity;           ///< where the beam enters it
};

/// A stack of halts whose lower part can be set aside, to be gone through several times.
class Halts {
public:
    void start(const Halt& root) {
        halts_[0] = root;
        set_aside_ = 0;
        size_ = 1;
    }
    bool empty() const { return size_ == set_aside_; }
    Halt pop() { return halts_[--size_]; }
    void push(const Halt& halt) { halts_[size_++] = halt; }
    /// Puts a halt below those of the same node that are nearer. `left`: the first of these.
    void insert(const Halt& halt, std::size_t first) {
        std::size_t place = size_++;
        for (; place > first && halts_[place - 1].entry < halt.entry; --place)
            halts_[place] = halts_[place - 1];
        halts_[place] = halt;
    }
    std::size_t size() const { return size_; }
    std::span<const Halt> left() const { return {&halts_[set_aside_], size_ - set_aside_}; }

    /// Sets aside what is left, once.
    void set_aside() { set_aside_ = size_; }
    /// Everything that was set aside is left again, and nothing else.
    void repeat() {
        std::copy_n(halts_.begin(), set_aside_, halts_.begin() + set_aside_);
        size_ = 2 * set_aside_;
    }

private:
    /// A node leaves seven children behind at most.
    static constexpr std::size_t on_one_way = (WideNode::width - 1) * Stack::deepest + 1;

    std::array<Halt, 3 * on_one_way> halts_;
    std::size_t size_ = 0, set_aside_ = 0;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
