#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rayshoot {

/// One call of the command line, as a script sees it.
struct Call {
    int code;
    std::string out, err;

    nlohmann::ordered_json json() const { return nlohmann::ordered_json::parse(out); }
};
/// With the built-in catalogue and the planted structures of faulty.h.
Call call(const std::vector<std::string>& arguments);

/// A fresh, empty folder for a test's files.
std::filesystem::path fresh_folder(const std::string& name);

}  // namespace rayshoot
