#pragma once

#include "bench/streams/ray_stream.h"

#include <filesystem>

/// The documented ray file (bench/README.md), little-endian on every machine.
namespace rayshoot {

inline constexpr std::string_view ray_file_magic = "RAYSHOOT";
inline constexpr std::uint32_t ray_file_version = 1;

/// Writes beside `path` and renames, so that a file that is there is whole.
/// Throws std::runtime_error with path and reason.
void write_ray_file(const std::filesystem::path& path, const RayStream& stream);

/// Throws std::runtime_error with path, the byte offset of what is wrong, and the remedy. Nothing
/// is allocated for a count that the size of the file does not bear out.
RayStream read_ray_file(const std::filesystem::path& path);

}  // namespace rayshoot
