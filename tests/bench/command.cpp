#include "tests/bench/command.h"

#include "bench/command_line.h"
#include "tests/bench/faulty.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <sstream>

namespace rayshoot {

Call call(const std::vector<std::string>& arguments) {
    std::vector<const char*> texts{"rayshoot"};
    for (const std::string& argument : arguments) texts.push_back(argument.c_str());
    std::ostringstream out, err;
    const int code =
        run(faulty_catalogue(), static_cast<int>(texts.size()), texts.data(), out, err);
    return {code, out.str(), err.str()};
}

std::filesystem::path fresh_folder(const std::string& name) {
    const auto folder = std::filesystem::path(testing::TempDir()) /
                        ("rayshoot_" + name + "_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace rayshoot
