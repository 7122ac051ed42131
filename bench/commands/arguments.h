#pragma once

#include "accel/core/catalogue.h"
#include "data/scene.h"
#include "tracer/camera.h"

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>
#include <string_view>

/// How arguments are read, the same for every subcommand. Each throws std::invalid_argument with
/// the text given and what would be accepted.
namespace rayshoot {

struct Size {
    int width = 0, height = 0;
};
/// "640x480".
Size parse_size(std::string_view text);

/// How a scene is rendered and counted unless told otherwise: NFF and SPD scenes by the SPD rules
/// (513 x 513 rays through pixel corners), others 512 x 512. `size`: "" for that default.
ImageFormat image_format(const Scene& scene, const std::string& size, int spp);

/// Pixel centres, for streams; `size` must be given.
ImageFormat stream_format(const std::string& size, int spp);

/// The number itself when it is one of threads.
int require_threads(int given);

/// Throws with the structure's own reason when it cannot take the scene.
void require_takes(const Catalogue& catalogue, const std::string& spec, const Scene& scene);

void print_json(std::ostream& out, const nlohmann::ordered_json& document);

}  // namespace rayshoot
