#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "tracer/colour_map.h"
#include "tracer/image_difference.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <ostream>

/// `rayshoot difference`: how far two images are apart.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

struct DifferenceArguments {
    std::string first, second, out;
    double tolerance = 0;
    bool json = false;
};

/// .exr: first - second, signed. .png: the largest channel's distance as a colour, from 0 to the
/// largest of all; grey where one image alone has a number.
void write_difference(const Image& first, const Image& second, const std::string& path) {
    if (path.ends_with(".exr")) {
        write_image(signed_difference(first, second), path);
        return;
    }
    const ScalarImage map = difference_map(first, second);
    write_image(coloured(map, common_scale({&map, 1}, Spacing::linear)), path);
}

Json to_json(const DifferenceArguments& arguments, const Image& image,
             const ImageDifference& apart) {
    const bool any = apart.largest > 0;
    return {{"schema", schema_version},
            {"first", arguments.first},
            {"second", arguments.second},
            {"width", image.width()},
            {"height", image.height()},
            {"tolerance", arguments.tolerance},
            {"pixels", apart.pixels},
            {"differing", apart.differing},
            {"incomparable", apart.incomparable},
            {"largest", apart.largest},
            {"largest_at", any ? Json{apart.largest_at.x, apart.largest_at.y} : Json(nullptr)},
            {"rms", apart.rms}};
}

std::string to_text(const ImageDifference& apart, double tolerance) {
    if (apart.agree() && apart.largest == 0) return "the images are equal\n";
    const auto number = [](double value) { return short_number(value); };
    std::string text =
        std::to_string(apart.differing) + " of " + std::to_string(apart.pixels) + " pixels differ";
    if (tolerance > 0) text += " by more than " + number(tolerance);
    text += "; largest difference " + number(apart.largest) + " at (" +
            std::to_string(apart.largest_at.x) + ", " + std::to_string(apart.largest_at.y) +
            "), root mean square " + number(apart.rms) + "\n";
    if (apart.incomparable > 0) {
        text += std::to_string(apart.incomparable) +
                " of them have a number in one image and none in the other\n";
    }
    return text;
}

int difference(const DifferenceArguments& arguments, const Invocation& invocation) {
    if (!(arguments.tolerance >= 0) || std::isinf(arguments.tolerance))
        throw std::invalid_argument("--tolerance must be a number from 0 up");
    if (!arguments.out.empty()) require_writable(arguments.out);
    const Image first = read_image(arguments.first), second = read_image(arguments.second);
    const ImageDifference apart = compare_images(first, second, arguments.tolerance);
    if (!arguments.out.empty()) write_difference(first, second, arguments.out);
    if (arguments.json) print_json(invocation.out, to_json(arguments, first, apart));
    else invocation.out << to_text(apart, arguments.tolerance);
    return apart.agree() ? exit_ok : exit_differences;
}

}  // namespace

void add_difference(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<DifferenceArguments>();
    CLI::App* command =
        app.add_subcommand("difference", "How far two images are apart; exit code 1 if they are");
    command->add_option("first", arguments->first, "Image file, .png or .exr")->required();
    command->add_option("second", arguments->second, "Another of the same size")->required();
    command->add_option("--tolerance", arguments->tolerance,
                        "How far a channel may be apart, linear RGB (0: not at all)");
    command->add_option("--out", arguments->out,
                        "Difference image: .png in colours, .exr signed numbers");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return difference(*arguments, invocation); };
    });
}

}  // namespace rayshoot
