#include "data/aff_file.h"

namespace rayshoot {

bool AffFile::shape(std::string_view keyword) {
    if (keyword == "s") add(read_sphere(tokens_));
    else if (keyword == "c") add(read_cone(tokens_));
    else if (keyword == "p") add(read_polygon(tokens_));
    else if (keyword == "pp") add(read_patch(tokens_));
    else if (keyword == "tt") textured(false);
    else if (keyword == "ttp") textured(true);
    else if (keyword == "tpa") deforming();
    else if (keyword == "m") mesh();
    else return false;
    return true;
}

void AffFile::add(AffShape shape) {
    std::vector<Material>& materials = reading_.model.materials;
    if (materials.empty()) materials.emplace_back();
    reading_.model.items.push_back({transforms_.back(),
                                    static_cast<std::uint32_t>(materials.size() - 1),
                                    std::move(shape), tokens_.where()});
}

void AffFile::mesh() {
    reading_.model.counts.meshes += first_time_;
    add(read_aff_mesh(tokens_, reading_.model.left_out));
}

void AffFile::textured(bool patch) {
    leave_out("texture " + std::string(tokens_.next()));
    Outline outline;
    for (int corner = 0; corner < 3; ++corner) {
        outline.corners.push_back(tokens_.three("corner of a textured triangle: x y z"));
        if (patch) outline.normals.push_back(tokens_.three("normal of a textured triangle"));
        tokens_.number("texture coordinate u");
        tokens_.number("texture coordinate v");
    }
    add(std::move(outline));
}

void AffFile::deforming() {
    constexpr std::int64_t shortest = 38;  // characters of a time and three corners with normals
    AffDeforming triangle;
    const std::int64_t most = most_to_come(tokens_, shortest);
    for (std::int64_t left = tokens_.integer("times of an animated triangle", 1, most); left > 0;
         --left) {
        Key<Outline>& key = triangle.keys.emplace_back();
        key.time = tokens_.number("time of an animated triangle");
        for (int corner = 0; corner < 3; ++corner) {
            key.value.corners.push_back(tokens_.three("corner of an animated triangle"));
            key.value.normals.push_back(tokens_.three("normal of an animated triangle"));
        }
        const std::size_t count = triangle.keys.size();
        if (count > 1 && !(triangle.keys[count - 2].time < key.time))
            tokens_.refuse("the times of an animated triangle must ascend");
    }
    leave_out("deformation while the shutter is open");
    add(std::move(triangle));
}

}  // namespace rayshoot
