#pragma once

#include "accel/core/intersector.h"

#include "tracer/camera.h"
#include "tracer/integrator/irradiance_cache.h"
#include "tracer/integrator/transport.h"

namespace rayshoot {

/// The irradiances that an image interpolates between. Ward, Rubinstein & Clear 1988 compute them
/// where and when an image needs one, so what a pixel gets depends on the pixels before it. Here
/// all are there before the image is begun: cells of the raster are looked at in ever finer
/// lattices, and where the matt surface behind one finds no record good enough, one is made from
/// `settings.gather` rays over its hemisphere. Records of a chunk of cells are made side by side
/// and inserted in the order of cells: the same bits for any structure and number of threads.
/// `threads`: 0 as many as the machine has. Rays of this pass are in no count.
IrradianceCache fill_irradiance_cache(const Scene& scene, const Accel& accel,
                                      const CameraRays& camera, const TransportSettings& settings,
                                      std::size_t batch, int threads);

}  // namespace rayshoot
