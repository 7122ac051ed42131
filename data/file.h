#pragma once

#include <filesystem>
#include <string>

/// Input files, whole, unpacked where their name ends in .xz or .gz.
namespace rayshoot {

/// Throws std::invalid_argument, saying what to do, for a path that is empty, missing, not a
/// regular file (a directory, pipe or device), unreadable or damaged, and for one that unpacks to
/// more than any scene does.
std::string read_file(const std::filesystem::path& path);

/// The path's extension without the packer's: ".nff" for "balls.nff.xz", in lower case.
std::string format_of(const std::filesystem::path& path);

}  // namespace rayshoot
