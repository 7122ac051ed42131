#include "accel/simd/leaf_packer.h"

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Whether blocks up to `end` can stand in a leaf's word.
bool fits(std::size_t end, std::uint32_t blocks, std::uint32_t most) {
    return blocks > 0 && blocks <= PackedLeaf::most_blocks && end <= most;
}

}  // namespace

LeafPacker::LeafPacker(const Geometry& geometry) : geometry_(&geometry) {
    leaves_.blocks_.reserve(geometry.size() / 3 + 1);
}

void LeafPacker::set(TriangleBlock& block, std::size_t lane, std::uint32_t primitive) const {
    block.set(lane, geometry_->triangle(geometry_->ref(primitive).index), primitive);
}

void LeafPacker::set(SphereBlock& block, std::size_t lane, std::uint32_t primitive) const {
    block.set(lane, geometry_->sphere(geometry_->ref(primitive).index), primitive);
}

/// Returns how many blocks they make.
template <class Block>
std::uint32_t LeafPacker::add_blocks(std::span<const std::uint32_t> members) {
    const std::size_t before = leaves_.blocks_.size();
    for (std::size_t i = 0; i < members.size(); i += Block::width) {
        Block block;
        for (std::size_t lane = 0; lane < Block::width && i + lane < members.size(); ++lane)
            set(block, lane, members[i + lane]);
        leaves_.blocks_.push_back(block);
    }
    return static_cast<std::uint32_t>(leaves_.blocks_.size() - before);
}

PackedLeaf LeafPacker::add(std::span<const std::uint32_t> members) {
    triangles_.clear();
    spheres_.clear();
    const auto first_other = static_cast<std::uint32_t>(others_.size());
    for (const std::uint32_t primitive : members) {
        const PrimitiveRef& ref = geometry_->ref(primitive);
        const bool still = ref.motion == no_motion;
        if (still && ref.kind == PrimitiveKind::triangle) triangles_.push_back(primitive);
        else if (still && ref.kind == PrimitiveKind::sphere) spheres_.push_back(primitive);
        else others_.push_back(primitive);
    }
    const auto first = static_cast<std::uint32_t>(leaves_.blocks_.size());
    const LeafRange others{first_other, static_cast<std::uint32_t>(others_.size()) - first_other};
    const std::uint32_t of_triangles = add_blocks<TriangleBlock>(triangles_);
    const std::uint32_t of_spheres = add_blocks<SphereBlock>(spheres_);
    const std::size_t end = leaves_.blocks_.size();
    if (end > 0xffffffff) throw std::length_error("more than 2^32 - 1 blocks of leaves");

    const bool triangles_only = of_spheres == 0 && others.count == 0;
    if (triangles_only && fits(end, of_triangles, PackedLeaf::most_triangle_blocks))
        return PackedLeaf::triangles(first, of_triangles);
    const bool spheres_only = of_triangles == 0 && others.count == 0;
    if (spheres_only && fits(end, of_spheres, PackedLeaf::most_sphere_blocks))
        return PackedLeaf::spheres(first, of_spheres);
    if (leaves_.mixed_.size() >= PackedLeaf::most_mixed)
        throw std::length_error("more than 2^29 - 1 leaves of several kinds");
    if (others.count > 0) ranges_.push_back(others);
    leaves_.mixed_.push_back({first, of_triangles, of_spheres, others});
    return PackedLeaf::mixed(static_cast<std::uint32_t>(leaves_.mixed_.size() - 1));
}

bool LeafPacker::make_room_for_triangles(std::size_t blocks) {
    if (!geometry_->only_static_triangles() || blocks > PackedLeaf::most_triangle_blocks)
        return false;
    leaves_.blocks_.resize(blocks);
    return true;
}

PackedLeaf LeafPacker::set_triangles(std::uint32_t first_block,
                                     std::span<const std::uint32_t> members) {
    std::uint32_t blocks = 0;
    for (std::size_t i = 0; i < members.size(); i += TriangleBlock::width) {
        TriangleBlock& block =
            (new (&leaves_.blocks_[first_block + blocks++]) LeafBlock(TriangleBlock()))->triangles;
        // Where there are no other kinds, a triangle's number is its index.
        for (std::size_t lane = 0; lane < block.width && i + lane < members.size(); ++lane)
            block.set(lane, geometry_->triangle(members[i + lane]), members[i + lane]);
    }
    return PackedLeaf::triangles(first_block, blocks);
}

PackedLeaves LeafPacker::build() && {
    leaves_.padding_ = geometry_->padding();
    leaves_.precision_ = geometry_->precision();
    leaves_.others_ = Leaves(*geometry_, others_, ranges_);
    return std::move(leaves_);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
