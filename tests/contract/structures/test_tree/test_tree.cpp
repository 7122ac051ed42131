#include "tests/contract/structures/test_tree/test_tree.h"

#include <numeric>
#include <stdexcept>

namespace rayshoot::contract {
namespace {

constexpr std::array<std::pair<std::string_view, Fault>, 16> faults{
    {{"skipped_child", Fault::skipped_child},
     {"wrong_order", Fault::wrong_order},
     {"early_stop", Fault::early_stop},
     {"stop_at_tie", Fault::stop_at_tie},
     {"lost_straddler", Fault::lost_straddler},
     {"unclamped_t", Fault::unclamped_t},
     {"wrong_tie", Fault::wrong_tie},
     {"closed_limit", Fault::closed_limit},
     {"negative_zero", Fault::negative_zero},
     {"forgotten_t_min", Fault::forgotten_t_min},
     {"forgotten_time", Fault::forgotten_time},
     {"stale_mailbox", Fault::stale_mailbox},
     {"shared_any_hit", Fault::shared_any_hit},
     {"lost_remainder", Fault::lost_remainder},
     {"declining", Fault::declining},
     {"uncounted_cells", Fault::uncounted_cells}}};

Fault planted_fault(std::string_view name) {
    if (name == "none") return Fault::none;
    for (const auto& [known, fault] : faults)
        if (name == known) return fault;
    throw std::invalid_argument("test_tree: there is no fault '" + std::string(name) + "'");
}

}  // namespace

std::vector<std::string_view> fault_names() {
    std::vector<std::string_view> names;
    for (const auto& [name, fault] : faults) names.push_back(name);
    return names;
}

Leaves one_leaf_each(const Geometry& geometry) {
    std::vector<std::uint32_t> order(geometry.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<LeafRange> ranges;
    for (std::uint32_t i = 0; i < geometry.size(); ++i) ranges.push_back({i, 1});
    return Leaves(geometry, order, ranges);
}

TestTree::TestTree(const BuildInput& input, const Options& chosen)
    : geometry_(input.geometry),
      fault_(planted_fault(chosen.text("fault"))),
      tree_(input.geometry),
      leaves_(one_leaf_each(input.geometry)) {
    tree_.split_all(geometry_, has(Fault::lost_straddler) ? KdTree::Straddlers::with_their_centre
                                                          : KdTree::Straddlers::in_both);
}

Footprint TestTree::footprint() const {
    Footprint total{.interior = 0,
                    .leaves = 0,
                    .empty_leaves = 0,
                    .references = 0,
                    .depth = 0,
                    .bytes = tree_.bytes() + leaves_.bytes()};
    for (const KdTree::Node& node : tree_.nodes()) {
        *(node.leaf() ? total.leaves : total.interior) += 1;
        *total.empty_leaves += node.leaf() && node.primitives.empty();
        *total.references += node.primitives.size();
        total.depth = std::max<std::uint64_t>(*total.depth, static_cast<std::uint64_t>(node.depth));
    }
    return total;
}

}  // namespace rayshoot::contract
