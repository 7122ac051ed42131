#pragma once

#include <filesystem>
#include <string_view>

/// Output files that are either whole or not there.
namespace rayshoot {

/// Throws std::invalid_argument with path and reason when `path` could not be written: asked before
/// a long run, not after it. Creates nothing.
void require_writable_file(const std::filesystem::path& path);

/// Writes beside `path` and renames. Throws std::runtime_error with path and reason.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace rayshoot
