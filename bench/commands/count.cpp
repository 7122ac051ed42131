#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/specimen.h"
#include "bench/output/progress.h"
#include "bench/streams/promises.h"
#include "bench/streams/ray_file.h"
#include "bench/streams/record.h"
#include "bench/timing/clock.h"
#include "data/scenes.h"
#include "tracer/render.h"

#include <CLI/CLI.hpp>

#include <array>
#include <ostream>

/// `rayshoot count`: exact counts of one structure on one image, or on a file of rays.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, ray_kinds> ray_kind_names{"camera", "shadow", "secondary"};

struct CountArguments {
    std::string scene, structure, rules = "spd-readme", size, rays_file;
    int spp = 1;
    std::size_t batch = default_batch;
    bool json = false;
};

Rules parse_rules(const std::string& name) {
    if (name == "spd-readme") return Rules::spd_readme;
    if (name == "havran") return Rules::havran;
    throw std::invalid_argument("unknown rules \"" + name + "\"; there are spd-readme and havran");
}

void require_batch(std::size_t batch) {
    if (batch >= 1 && batch <= max_batch) return;
    throw std::invalid_argument("a batch has 1 to " + std::to_string(max_batch) + " rays, not " +
                                std::to_string(batch));
}

/// What a session counted, by ray kind. A yardstick cannot count, but its answers can be counted:
/// `answered` fills in rays and hits there.
Json counts_to_json(const Session& session, const RayCounts* answered) {
    Json result = Json::object();
    for (int i = 0; i < ray_kinds; ++i) {
        const auto kind = static_cast<RayKind>(i);
        const Counters* counters = session.counters(kind);
        Json counts = to_json(counters);
        if (!counters && answered) {
            counts["rays"] = answered->of(kind).rays;
            counts["hits"] = answered->of(kind).hits;
        }
        result[std::string(ray_kind_names[static_cast<std::size_t>(i)])] = std::move(counts);
    }
    return result;
}

Json members_to_json(const Accel& accel, const Session& session) {
    Json members = Json::array();
    for (std::size_t i = 0; i < accel.members().size(); ++i) {
        members.push_back({{"structure", accel.members()[i]->spec()},
                           {"rays", counts_to_json(*session.members()[i], nullptr)},
                           {"footprint", to_json(accel.members()[i]->footprint())}});
    }
    return members;
}

struct Counted {
    std::unique_ptr<Session> session;
    std::optional<RayCounts> answered;
    double seconds = 0;
};

Counted count_image(const Scene& scene, const Accel& accel, const ImageFormat& format, Rules rules,
                    std::size_t batch) {
    ProgressLine line;
    RenderSettings settings;
    settings.format = format;
    settings.transport.rules = rules;
    settings.batch = batch;
    settings.mode = Mode::counting;
    settings.progress = [&](double share, double left) { line.show(share, left, "count"); };
    RenderResult result = render(scene, accel, settings);
    return {std::move(result.session), result.counts, result.seconds};
}

Counted count_file(const RayStream& stream, const Accel& accel, std::size_t batch_size) {
    Counted counted;
    const Stopwatch watch;
    counted.session = accel.open(Mode::counting);
    std::vector<Hit> hits(batch_size);
    std::vector<std::uint8_t> occluded(batch_size);
    for (std::size_t first = 0; first < stream.size(); first += batch_size) {
        const RayBatch batch = stream.batch(first, batch_size);
        if (stream.question == Query::closest) counted.session->closest(batch, hits);
        else counted.session->occluded(batch, occluded);
    }
    counted.seconds = watch.seconds();
    return counted;
}

Table count_table(const Json& document) {
    Table table{{"", "camera", "shadow", "secondary"}, {}};
    for (const std::string_view event : event_names) {
        std::vector<std::string> cells{std::string(event)};
        for (const std::string_view kind : ray_kind_names) {
            const Json& value = document["rays"][std::string(kind)][std::string(event)];
            cells.push_back(value.is_null() ? not_measured : value.dump());
        }
        table.rows.push_back(std::move(cells));
    }
    if (const Json& lost = document["totally_reflected"]; !lost.is_null())
        table.rows.push_back({"totally_reflected", "", "", lost.dump()});
    return table;
}

/// What the builder has to say, on a line of its own; empty where it says nothing.
std::string remarks(const Json& document) {
    const auto remark = document["footprint"]["remark"].get<std::string>();
    return remark.empty() ? remark : "note: " + remark + '\n';
}

int count(const CountArguments& arguments, const Invocation& invocation) {
    const Rules rules = parse_rules(arguments.rules);
    require_batch(arguments.batch);
    require_spec(invocation.catalogue, arguments.structure);
    const bool from_file = !arguments.rays_file.empty();
    const RayStream stream = from_file ? read_ray_file(arguments.rays_file) : RayStream{};
    const Scene scene = load_scene(arguments.scene);
    const ImageFormat image = image_format(scene, arguments.size, arguments.spp);
    const ImageFormat format = from_file ? format_of(stream, image) : image;
    require_takes(invocation.catalogue, arguments.structure, scene);
    const BuildInput input = build_input(scene, format);
    require_promises_kept(input, stream);
    const Stopwatch watch;
    const auto accel = build(invocation.catalogue, arguments.structure, input);
    const double build_seconds = watch.seconds();
    const Counted counted = from_file ? count_file(stream, *accel, arguments.batch)
                                      : count_image(scene, *accel, format, rules, arguments.batch);
    Json document;
    document["schema"] = schema_version;
    document["scene"] = scene.name;
    document["structure"] = accel->spec();
    document["primitives"] = scene.geometry.size();
    document["rules"] = from_file ? Json(nullptr) : Json(arguments.rules);
    document["width"] = format.width;
    document["height"] = format.height;
    document["spp"] = format.spp;
    document["batch"] = arguments.batch;
    document["rays"] =
        counts_to_json(*counted.session, counted.answered ? &*counted.answered : nullptr);
    document["totally_reflected"] =
        counted.answered ? Json(counted.answered->totally_reflected) : Json(nullptr);
    document["footprint"] = to_json(accel->footprint());
    document["members"] = members_to_json(*accel, *counted.session);
    document["build_seconds"] = build_seconds;
    document["seconds"] = counted.seconds;
    if (arguments.json) print_json(invocation.out, document);
    else invocation.out << to_text(count_table(document)) << remarks(document);
    return 0;
}

}  // namespace

void add_count(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<CountArguments>();
    CLI::App* command = app.add_subcommand("count", "Count tests and steps on an image's rays");
    command->add_option("--scene", arguments->scene, "Scene string or file")->required();
    command->add_option("--structure", arguments->structure, "Structure spec")->required();
    command->add_option("--rules", arguments->rules, "spd-readme (default) or havran");
    command->add_option("--size", arguments->size, "WxH; default 513x513 (SPD, NFF) or 512x512");
    command->add_option("--spp", arguments->spp, "Camera rays per pixel");
    command->add_option("--batch", arguments->batch, "Most rays in one call (1024)");
    command->add_option("--rays-file", arguments->rays_file, "Count on the rays of this file");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return count(*arguments, invocation); };
    });
}

}  // namespace rayshoot
