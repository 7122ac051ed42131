#include "version/version.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace rayshoot {
namespace {

std::string_view version_of(const Version& version, std::string_view library) {
    const auto found =
        std::find_if(version.libraries.begin(), version.libraries.end(),
                     [&](const LibraryVersion& entry) { return entry.name == library; });
    return found == version.libraries.end() ? std::string_view{} : found->version;
}

TEST(Version, every_library_has_a_version_that_contains_a_number) {
    for (const LibraryVersion& library : version().libraries) {
        EXPECT_TRUE(std::any_of(library.version.begin(), library.version.end(),
                                [](unsigned char c) { return std::isdigit(c) != 0; }))
            << library.name << " " << library.version;
    }
}

TEST(Version, openmesh_is_read_from_its_header) {
    EXPECT_EQ(std::count(version_of(version(), "OpenMesh").begin(),
                         version_of(version(), "OpenMesh").end(), '.'),
              2);
}

TEST(Version, commit_is_a_hash_or_unknown) {
    std::string commit(version().commit);
    if (const auto dirty = commit.find("-dirty"); dirty != std::string::npos) commit.erase(dirty);
    EXPECT_TRUE(
        commit == "unknown" ||
        (commit.size() >= 12 && std::all_of(commit.begin(), commit.end(),
                                            [](unsigned char c) { return std::isxdigit(c); })))
        << commit;
}

TEST(Version, flags_forbid_contraction_and_hold_no_path) {
    EXPECT_NE(version().flags.find("-ffp-contract=off"), std::string_view::npos);
    EXPECT_EQ(version().flags.find('/'), std::string_view::npos);
}

TEST(Version, licence_is_gpl_exactly_with_cgal) {
    const bool holds_cgal = !version_of(version(), "CGAL").empty();
    EXPECT_EQ(version().licence, holds_cgal ? "GPL-3.0-or-later" : "Apache-2.0");
    EXPECT_EQ(describe(version()).find("as a whole") != std::string::npos, holds_cgal);
}

}  // namespace
}  // namespace rayshoot
