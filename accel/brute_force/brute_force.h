#pragma once

#include "accel/core/structure.h"

/// Every ray against every object, in order: what all other structures save, and the oracle that
/// they are held against (Appel 1968; Whitted 1980).
namespace rayshoot::inline RAYSHOOT_ISA {

class BruteForce {
public:
    static constexpr std::string_view name = "brute_force";
    static constexpr std::string_view summary =
        "every ray against every object, in order; the oracle";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::array<OptionInfo, 0> options{};
    static constexpr std::array<std::string_view, 1> configurations{"brute_force"};
    struct Scratch {};

    BruteForce(const BuildInput& input, const Options&);

    template <Query Q, Counter C>
    bool one(const Ray& ray, Source, Hit& hit, Scratch&, C& count) const {
        leaves_.template test<Q>(everything_, leaves_.prepared(ray), hit, count);
        return true;
    }
    Footprint footprint() const;

private:
    LeafRange everything_;
    Leaves leaves_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
