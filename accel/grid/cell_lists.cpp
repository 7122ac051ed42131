#include "accel/grid/cell_lists.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr std::size_t primitives_per_task = 2048;
constexpr std::size_t cells_per_task = 8192;

struct Reference {
    std::uint32_t cell, primitive;
};

using Chunk = std::vector<Reference>;

/// Whether a primitive is in a cell is asked once, and kept: it is what takes the time.
Chunk references_of(const Membership& membership, const Lattice& lattice,
                    std::span<const std::uint32_t> primitives) {
    Chunk chunk;
    chunk.reserve(2 * primitives.size());
    for (const std::uint32_t primitive : primitives) {
        const CellRange range = lattice.around(membership.box(primitive));
        const bool only_one = range.size() == 1;
        for_each_cell(range, [&](const Cell& cell) {
            if (only_one || membership.in_cell(primitive, lattice.box(cell)))
                chunk.push_back({static_cast<std::uint32_t>(lattice.number(cell)), primitive});
        });
    }
    return chunk;
}

std::uint32_t fetch_increment(std::uint32_t& counter) {
    return std::atomic_ref(counter).fetch_add(1, std::memory_order_relaxed);
}

template <class Work>
void for_each_part(std::size_t size, std::size_t part, const Work& work) {
    const std::size_t parts = (size + part - 1) / part;
    if (parts == 1) return work(0, 0, size);
    tbb::parallel_for(std::size_t{0}, parts,
                      [&](std::size_t i) { work(i, i * part, std::min(size, (i + 1) * part)); });
}

/// From numbers of members to where each cell's end: filled from the end, they become its first.
std::uint32_t sum_up(RawArray<std::uint32_t>& counts) {
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts) count = sum += count;
    return sum;
}

}  // namespace

std::uint64_t box_references(const Membership& membership, const Lattice& lattice,
                             std::span<const std::uint32_t> primitives) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, primitives.size(), primitives_per_task),
        std::uint64_t{0},
        [&](const auto& part, std::uint64_t sum) {
            for (std::size_t i = part.begin(); i < part.end(); ++i)
                sum += lattice.around(membership.box(primitives[i])).size();
            return sum;
        },
        std::plus<>());
}

CellLists list_members(const Membership& membership, const Lattice& lattice,
                       std::span<const std::uint32_t> primitives) {
    const std::size_t cells = lattice.size();
    CellLists lists{RawArray<std::uint32_t>(cells + 1), {}};
    std::fill(lists.first.begin(), lists.first.end(), 0);
    std::vector<Chunk> chunks((primitives.size() + primitives_per_task - 1) / primitives_per_task);
    for_each_part(primitives.size(), primitives_per_task,
                  [&](std::size_t number, std::size_t first, std::size_t end) {
                      chunks[number] = references_of(membership, lattice,
                                                     primitives.subspan(first, end - first));
                      for (const Reference& reference : chunks[number])
                          fetch_increment(lists.first[reference.cell]);
                  });
    lists.members = RawArray<std::uint32_t>(sum_up(lists.first));
    for_each_part(
        primitives.size(), primitives_per_task, [&](std::size_t number, std::size_t, std::size_t) {
            for (const auto& [cell, primitive] : chunks[number]) {
                std::atomic_ref<std::uint32_t> end(lists.first[cell]);
                lists.members[end.fetch_sub(1, std::memory_order_relaxed) - 1] = primitive;
            }
        });
    // Which thread came first is not to be seen.
    for_each_part(cells, cells_per_task, [&](std::size_t, std::size_t first, std::size_t end) {
        for (std::size_t cell = first; cell < end; ++cell)
            std::sort(lists.members.begin() + lists.first[cell],
                      lists.members.begin() + lists.first[cell + 1]);
    });
    return lists;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
