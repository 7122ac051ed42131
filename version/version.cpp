#include "version/version.h"

#include "accel/core/isa.h"
#include "version_commit.h"
#include "version_facts.h"

#define RAYSHOOT_TEXT_OF(word) #word
#define RAYSHOOT_TEXT(macro) RAYSHOOT_TEXT_OF(macro)

namespace rayshoot {

Version version() {
    return {.release = facts::release,
            .commit = facts::commit,
            .compiler = facts::compiler,
            .build_type = facts::build_type,
            .flags = facts::flags,
            .instruction_set = RAYSHOOT_TEXT(RAYSHOOT_ISA),
            .licence = facts::licence,
            .libraries = {std::begin(facts::libraries), std::end(facts::libraries)}};
}

std::string describe(const Version& version) {
    std::string text;
    const auto line = [&text](std::string_view key, std::string_view value) {
        text.append(key).append(16 - key.size(), ' ').append(value).append("\n");
    };
    line("rayshoot", version.release);
    line("commit", version.commit);
    line("compiler", version.compiler);
    line("build type", version.build_type);
    line("flags", version.flags);
    line("instruction set", version.instruction_set);
    for (const LibraryVersion& library : version.libraries) line(library.name, library.version);
    line("licence", version.licence);
    if (version.licence != "Apache-2.0") {
        text +=
            "This build holds the CGAL yardstick: as a whole it is under the GNU General Public "
            "License,\nversion 3 or later. See NOTICE.\n";
    }
    return text;
}

}  // namespace rayshoot
