#include "bench/comparison/specimen.h"

namespace rayshoot {

Specimen::Specimen() {
    GeometryBuilder builder;
    builder.add_triangle(vec3{-1, -1, -3}, vec3{1, -1, -3}, vec3{0, 1, -3});
    geometry_ = std::move(builder).build();
    lights_.emplace_back().samples.include(vec3{0});
    view_.width = view_.height = 2;
    view_.across = vec3{1, 0, 0};
    view_.down = vec3{0, -1, 0};
}

void require_spec(const Catalogue& catalogue, const std::string& spec) {
    const Specimen specimen;
    if (refusal(catalogue, spec, specimen.input().geometry).empty()) {
        static_cast<void>(build(catalogue, spec, specimen.input()));
    }
}

}  // namespace rayshoot
