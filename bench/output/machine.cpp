#include "bench/output/machine.h"

#include "version/version.h"

#include <nlohmann/json.hpp>

#include <cctype>
#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

namespace rayshoot {

std::string processor_model() {
    std::ifstream in("/proc/cpuinfo");  // x86 Linux; elsewhere there may be no such line
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

int processor_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

std::string slug(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) result += static_cast<char>(std::tolower(byte));
        else if (!result.empty() && result.back() != '-') result += '-';
    }
    while (!result.empty() && result.back() == '-') result.pop_back();
    return result.empty() ? "unknown" : result;
}

std::string today() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
    return text;
}

nlohmann::ordered_json provenance() {
    const Version made_by = version();
    nlohmann::ordered_json libraries = nlohmann::ordered_json::object();
    for (const LibraryVersion& library : made_by.libraries) {
        libraries[std::string(library.name)] = library.version;
    }
    return {{"release", made_by.release},      {"commit", made_by.commit},
            {"compiler", made_by.compiler},    {"build_type", made_by.build_type},
            {"flags", made_by.flags},          {"instruction_set", made_by.instruction_set},
            {"libraries", libraries},          {"processor", processor_model()},
            {"processors", processor_count()}, {"date", today()}};
}

}  // namespace rayshoot
