#include "bench/gallery/gallery.h"

#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/specimen.h"
#include "bench/output/machine.h"
#include "bench/output/progress.h"
#include "bench/output/table.h"

#include <CLI/CLI.hpp>

#include <ostream>

/// `rayshoot gallery`: a picture of every effect.
namespace rayshoot {
namespace {

struct GalleryArguments {
    std::string out, structure = "bvh8";
    std::vector<std::string> pictures;
    int threads = processor_count();
    bool list = false;
};

Table exhibit_table() {
    Table table{{"picture", "effect", "scene", "caption"}, {}};
    for (const gallery::Exhibit& exhibit : gallery::exhibits()) {
        table.rows.push_back({std::string(exhibit.name), std::string(exhibit.effect),
                              std::string(exhibit.scene), std::string(exhibit.caption)});
    }
    return table;
}

int make_gallery(const GalleryArguments& arguments, const Invocation& invocation) {
    if (arguments.list) {
        invocation.out << to_text(exhibit_table());
        return 0;
    }
    if (arguments.out.empty())
        throw std::invalid_argument("--out is needed: the folder that the pictures go into");
    require_spec(invocation.catalogue, arguments.structure);
    const auto chosen = gallery::chosen_exhibits(arguments.pictures);
    const gallery::Easel easel{invocation.catalogue, arguments.structure,
                               require_threads(arguments.threads)};
    const std::filesystem::path folder = arguments.out;
    std::filesystem::create_directories(folder);
    Progress progress(chosen.size());
    std::vector<gallery::Hung> hung;
    for (const gallery::Exhibit& exhibit : chosen) {
        progress.advance(std::string(exhibit.name));
        hung.push_back(gallery::hang(exhibit, easel, folder));
    }
    gallery::write_page(hung, arguments.structure, folder);
    invocation.out << (folder / "README.md").string() << ": " << hung.size() << " pictures\n";
    return 0;
}

}  // namespace

void add_gallery(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<GalleryArguments>();
    CLI::App* command = app.add_subcommand("gallery", "A picture of every effect of the tracer");
    command->add_option("--out", arguments->out, "Folder for the pictures and README.md");
    command->add_option("--picture", arguments->pictures, "Names; default: all of them");
    command->add_option("--structure", arguments->structure, "Structure spec (bvh8)");
    command->add_option("--threads", arguments->threads, "Threads (all)");
    command->add_flag("--list", arguments->list, "Only say which pictures there are");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] {
            return make_gallery(*arguments, invocation);
        };
    });
}

}  // namespace rayshoot
