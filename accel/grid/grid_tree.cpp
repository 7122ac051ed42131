#include "accel/grid/grid_tree.h"

#include "accel/grid/cell_lists.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr double spare_references = 1000;   // for scenes of a few objects
constexpr double most_references = 0x1p31;  // they are numbered

class Builder {
public:
    Builder(const Membership& membership, std::uint32_t primitives, const GridSettings& settings)
        : membership_(membership),
          settings_(settings),
          references_left_(
              std::min(settings.bound * primitives + spare_references, most_references)) {}

    GridTree build(std::span<const std::uint32_t> primitives) && {
        std::vector<Part> parts(1);
        parts[0].lattice = outermost(primitives);
        parts[0].lists = list_members(membership_, parts[0].lattice, primitives);
        while (!parts.empty()) {
            tree_.depth += 1;
            std::vector<Part> finer = subdivided(parts);
            for (Part& part : parts) add(part);
            parts = std::move(finer);
        }
        return std::move(tree_);
    }

private:
    /// A grid with what its cells hold.
    struct Part {
        Lattice lattice;
        CellLists lists;
        std::vector<std::pair<std::size_t, std::uint32_t>> grids;  ///< cells, grids in them
    };
    struct Split {
        std::size_t part, cell;
        std::span<const std::uint32_t> members;
        Lattice lattice;
        std::uint64_t references;
    };

    Lattice outermost(std::span<const std::uint32_t> primitives) {
        Box space = membership_.space();
        space.lo -= settings_.lowered;
        space.hi -= settings_.lowered;
        Cell cells =
            settings_.resolution.cells(space, double(primitives.size()), settings_.top_density);
        const Cell wanted = cells;
        while (true) {
            const Lattice lattice(space, cells);
            const auto references = double(box_references(membership_, lattice, primitives));
            if (references <= references_left_ || lattice.size() == 1) {
                references_left_ -= references;
                if (cells != wanted)
                    tree_.remark = "resolution lowered from " + std::to_string(wanted[0]) + "x" +
                                   std::to_string(wanted[1]) + "x" + std::to_string(wanted[2]) +
                                   " at the bound on references";
                return lattice;
            }
            for (int& along : cells) along = std::max(1, along * 9 / 10);
        }
    }

    /// The grids in the cells of these, as far as the bound allows.
    std::vector<Part> subdivided(std::vector<Part>& parts) {
        std::vector<Split> splits;
        if (tree_.depth < settings_.levels)
            for (std::size_t i = 0; i < parts.size(); ++i) find_splits(parts[i], i, splits);
        tbb::parallel_for(std::size_t{0}, splits.size(), [&](std::size_t i) {
            splits[i].references =
                box_references(membership_, splits[i].lattice, splits[i].members);
        });
        const auto too_many = [&](const Split& split) {
            const auto references = double(split.references);
            const bool refused = references > references_left_;
            references_left_ -= refused ? 0 : references;
            return refused;
        };
        const std::size_t wanted = splits.size();
        std::erase_if(splits, too_many);
        if (splits.size() < wanted)
            tree_.remark = std::to_string(wanted - splits.size()) +
                           " cells left whole at the bound on references";
        std::vector<Part> finer(splits.size());
        tbb::parallel_for(std::size_t{0}, splits.size(), [&](std::size_t i) {
            finer[i].lattice = splits[i].lattice;
            finer[i].lists = list_members(membership_, splits[i].lattice, splits[i].members);
        });
        for (const Split& split : splits)
            parts[split.part].grids.emplace_back(split.cell, ++grids_named_);
        return finer;
    }

    void find_splits(const Part& part, std::size_t number, std::vector<Split>& splits) const {
        Resolution resolution = settings_.resolution;
        if (resolution.rule == ResolutionRule::fixed) resolution.rule = ResolutionRule::cleary;
        for_each_cell({{0, 0, 0}, part.lattice.last()}, [&](const Cell& at) {
            const std::size_t cell = part.lattice.number(at);
            const auto members = part.lists.of(cell);
            if (members.size() <= settings_.leaf) return;
            const Box box = part.lattice.box(at);
            const Cell cells = resolution.cells(box, double(members.size()), settings_.density);
            if (cells == Cell{1, 1, 1}) return;
            splits.push_back({number, cell, members, Lattice(box, cells), 0});
        });
    }

    void add(const Part& part) {
        const std::size_t first = tree_.cells.size(), size = part.lattice.size();
        if (first + size > 0xffffffff) throw std::length_error("a grid of more than 2^32 cells");
        tree_.grids.push_back({part.lattice, static_cast<std::uint32_t>(first)});
        tree_.cells.resize(first + size, CellWord::empty());
        for (const auto& [cell, grid] : part.grids)
            tree_.cells[first + cell] = CellWord::grid(grid);
        for (std::size_t cell = 0; cell < size; ++cell) {
            const auto members = part.lists.of(cell);
            CellWord& word = tree_.cells[first + cell];
            if (!word.is_empty()) continue;
            tree_.empty_cells += members.empty();
            if (members.empty()) continue;
            word = CellWord::leaf(static_cast<std::uint32_t>(tree_.leaves.size()));
            tree_.leaves.push_back({static_cast<std::uint32_t>(tree_.members.size()),
                                    static_cast<std::uint32_t>(members.size())});
            tree_.members.insert(tree_.members.end(), members.begin(), members.end());
        }
        measure_clearance(settings_.skip, part.lattice,
                          std::span(tree_.cells).subspan(first, size));
    }

    const Membership& membership_;
    const GridSettings& settings_;
    GridTree tree_;
    double references_left_;
    std::uint32_t grids_named_ = 0;  ///< in the order in which they are added
};

}  // namespace

GridTree build_grid_tree(const BuildInput& input, const Membership& membership,
                         const GridSettings& settings) {
    std::vector<std::uint32_t> primitives(input.geometry.size());
    std::iota(primitives.begin(), primitives.end(), 0);
    if (primitives.empty()) return {};
    return Builder(membership, input.geometry.size(), settings).build(primitives);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
