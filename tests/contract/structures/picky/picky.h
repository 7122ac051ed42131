#pragma once

#include "accel/core/structure.h"

#include <numeric>

/// A partial structure that declines by rule and answers the rest by testing everything.
namespace rayshoot::contract {

class Picky {
public:
    enum class Rule : std::uint8_t { none, all, odd, sourceless };

    static constexpr std::string_view name = "picky";
    static constexpr std::string_view summary =
        "test only: partial, declines by place in the batch";
    static constexpr bool complete = false, remembers = false;
    static constexpr std::array options{
        OptionInfo{"declines", "none|all|odd|sourceless", "odd", "which rays of a batch"},
        OptionInfo{"serves", "all|camera|shadow|closest|nothing", "all",
                   "what it is asked at all"}};
    static constexpr std::array<std::string_view, 5> configurations{
        "picky+bvh", "picky:declines=all+bvh", "picky:declines=none+bvh",
        "picky:declines=sourceless+bvh", "picky:serves=closest+bvh"};
    struct Scratch {};

    Picky(const BuildInput& input, const Options& chosen)
        : rule_(chosen.choice<Rule>("declines", {{"none", Rule::none},
                                                 {"all", Rule::all},
                                                 {"odd", Rule::odd},
                                                 {"sourceless", Rule::sourceless}})),
          serves_(chosen.choice<Serves>("serves", {{"all", {true, true, true, true}},
                                                   {"camera", {true, false, false, true}},
                                                   {"shadow", {false, true, false, true}},
                                                   {"closest", {true, true, true, false}},
                                                   {"nothing", {false, false, false, false}}})),
          everything_{0, input.geometry.size()} {
        std::vector<std::uint32_t> order(input.geometry.size());
        std::iota(order.begin(), order.end(), 0u);
        leaves_ = Leaves(input.geometry, order, {&everything_, 1});
    }

    bool serves(Query query, RayKind kind) const {
        return serves_.kinds[static_cast<std::size_t>(kind)] &&
               (query == Query::closest || serves_.occluded);
    }

    template <Query Q, Counter C>
    void many(const RayBatch& batch, Answers<Q>& answers, Scratch&, C& count) const {
        for (std::size_t i = 0; i < batch.rays.size(); ++i) {
            if (declines(batch, i)) {
                answers.decline(i);
                continue;
            }
            Hit hit = nothing_yet(batch.rays[i]);
            leaves_.template test<Q>(everything_, leaves_.prepared(batch.rays[i]), hit, count);
            answers.store(i, hit);
        }
    }
    Footprint footprint() const { return {.bytes = leaves_.bytes()}; }

private:
    struct Serves {
        std::array<bool, ray_kinds> kinds;
        bool occluded;

        Serves(bool camera, bool shadow, bool secondary, bool any_hit)
            : kinds{camera, shadow, secondary}, occluded(any_hit) {}
    };

    bool declines(const RayBatch& batch, std::size_t i) const {
        switch (rule_) {
            case Rule::none:
                return false;
            case Rule::all:
                return true;
            case Rule::odd:
                return i % 2 == 1;
            case Rule::sourceless:
                return batch.source.empty();
        }
        return true;
    }

    Rule rule_;
    Serves serves_;
    LeafRange everything_;
    Leaves leaves_;
};

}  // namespace rayshoot::contract
