#pragma once

#include <memory>
#include <string>

#include "accel/core/catalogue.h"
#include "data/scene.h"
#include "tracer/render.h"

/// Small scenes and shorthands for the tracer's tests.
namespace rayshoot::tracer_tests {

/// One of each primitive kind on a floor, with a mirror, glass and two lights.
Scene small_scene();

/// Every length times `factor`. Triangles get vertex normals, whether they had any or not.
Scene scaled(const Scene& scene, float factor);

std::unique_ptr<Accel> build(const Scene& scene, const std::string& spec,
                             const ImageFormat& format);
RenderResult render(const Scene& scene, const std::string& spec, const RenderSettings& settings);

}  // namespace rayshoot::tracer_tests
