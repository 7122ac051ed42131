#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What this build is: the provenance of every result, and the text of `rayshoot --version`.
namespace rayshoot {

struct LibraryVersion {
    std::string_view name;
    std::string_view version;  ///< of the headers that were compiled against
};

struct Version {
    std::string_view release;          ///< of the project, "0.1.0"
    std::string_view commit;           ///< "1a2b3c4d5e6f", "-dirty" appended; "unknown" outside git
    std::string_view compiler;         ///< "GNU 12.2.0"
    std::string_view build_type;       ///< "Release"
    std::string_view flags;            ///< all that decide about code, without paths
    std::string_view instruction_set;  ///< name of the inline namespace: "avx2"
    std::string_view licence;          ///< SPDX expression of the build as a whole
    std::vector<LibraryVersion> libraries;
};

Version version();

/// Several lines, the last ending in a newline; says so when the build as a whole is under the GPL.
std::string describe(const Version& version);

}  // namespace rayshoot
