#pragma once

#include "data/aff_model.h"
#include "data/animation.h"

#include <functional>
#include <string>

/// AFF, the animated file format of BART (Lext, Assarsson & Moeller 2000): NFF with key frames,
/// transforms, indexed meshes and includes. data/README.md has the entities and what is made of
/// them.
namespace rayshoot {

/// The text of an included file by its path relative to the main file's folder. Throws
/// std::invalid_argument, saying what to do, when there is none.
using AffFiles = std::function<std::string(const std::string& path)>;

/// Everything that the file and its includes say. `name`: the main file's, for errors. Throws
/// std::invalid_argument with file:line and the remedy for anything that is not AFF, and for a file
/// that includes itself.
AffModel read_aff_model(std::string text, const std::string& name, const AffFiles& files);

/// The scene at one frame. Static transforms are baked; what key frames move stands where the
/// shutter opens and gets one rigid motion to where it closes (of a scale that changes meanwhile,
/// the former stays). Throws std::invalid_argument with file:line for a transform without its key
/// frames or one that cannot be undone, for spheres and cones that are scaled unevenly, and where
/// there is no view.
Scene aff_scene(const AffModel& model, const std::string& name, Precision precision,
                const Frame& frame);

}  // namespace rayshoot
