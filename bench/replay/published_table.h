#pragma once

#include "bench/replay/measure.h"

#include <filesystem>
#include <optional>

/// A published table as a file: data/published/README.md describes its columns.
namespace rayshoot {

struct PublishedNumber {
    std::size_t line = 0;  ///< of the file, from 1
    std::string structure, setting, scene, metric;
    double value = 0;
    std::string measure;              ///< how we come by it
    std::optional<double> tolerance;  ///< share of the value; 0: exact; nullopt: none is promised
    std::optional<double> ours;       ///< where none is promised: our own number, which is to stay
    std::string spec;                 ///< of the structure that is rebuilt
};

struct PublishedTable {
    std::filesystem::path path;
    std::vector<PublishedNumber> numbers;
};

/// Throws std::invalid_argument with file, line and remedy.
PublishedTable read_published(const std::filesystem::path& path);

/// The same for something that is wrong with a number only once it is looked at.
[[noreturn]] void refuse_line(const std::filesystem::path& path, std::size_t line,
                              const std::string& what);

}  // namespace rayshoot
