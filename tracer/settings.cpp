#include "tracer/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>

#include "data/file.h"
#include "tracer/lens.h"
#include "tracer/wavefront.h"

namespace rayshoot {
namespace {

/// The text after the '='. Each function throws std::invalid_argument with what is accepted.
class Value {
public:
    explicit Value(std::string_view text) : text_(text) {}

    std::string_view text() const { return text_; }
    double number(double least, double most) const { return parsed<double>(text_, least, most); }
    float real(float least, float most) const {
        return static_cast<float>(number(double{least}, double{most}));
    }
    int integer(int least, int most) const { return parsed<int>(text_, least, most); }
    /// The place of the text among `names`.
    template <class Enum, std::size_t Count>
    Enum among(const std::array<std::string_view, Count>& names) const {
        const auto found = std::ranges::find(names, text_);
        if (found != names.end()) return static_cast<Enum>(found - names.begin());
        std::string known;
        for (const std::string_view name : names)
            known += (known.empty() ? "" : ", ") + std::string(name);
        throw std::invalid_argument("'" + std::string(text_) + "' is none of: " + known);
    }

private:
    template <class Number>
    static Number parsed(std::string_view text, Number least, Number most) {
        Number value{};
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (error == std::errc{} && stop == end && value >= least && value <= most) return value;
        std::ostringstream wrong;
        wrong << '\'' << text << "' is not a number from " << least << " to " << most;
        throw std::invalid_argument(wrong.str());
    }

    std::string_view text_;
};

constexpr std::array<std::string_view, 2> rules_names{"spd", "havran"};
constexpr std::array<std::string_view, 2> orders{"pixel", "blue_noise"};
constexpr std::array<std::string_view, 2> time_maps{"stratified", "cook"};
constexpr std::array<std::string_view, 2> adaptations{"sequential", "two_pass"};
constexpr float longest = 1e30f;  // scene units; more overflows when squared

AdaptiveSettings& adaptive(ImageSettings& settings) {
    auto& adaptive = settings.render.adaptive;
    if (!adaptive) adaptive.emplace();
    return *adaptive;
}

struct Setting {
    std::string_view key, accepts, meaning;
    void (*set)(ImageSettings&, const Value&);
};

constexpr std::array settings_table{
    Setting{
        "spp", "1 to 65536; 1", "samples per pixel",
        [](ImageSettings& s, const Value& v) { s.render.format.spp = v.integer(1, largest_spp); }},
    Setting{"seed", "0 to 2147483647; 0", "of all random numbers",
            [](ImageSettings& s, const Value& v) {
                s.render.format.seed = static_cast<std::uint32_t>(v.integer(0, 0x7fffffff));
            }},
    Setting{"sampler", "random, regular, jitter, gaussian, sobol; jitter",
            "how the samples of a pixel are spread over all dimensions",
            [](ImageSettings& s, const Value& v) { s.render.sampler = sampler_kind(v.text()); }},
    Setting{
        "order", "pixel, blue_noise; pixel", "of sobol: errors of neighbouring pixels differ",
        [](ImageSettings& s, const Value& v) { s.render.blue_noise = v.among<int>(orders) == 1; }},
    Setting{"time", "stratified, cook; stratified",
            "subframes of the samples: by chance, or by Cook's precomputed map",
            [](ImageSettings& s, const Value& v) {
                s.render.cook_time = v.among<int>(time_maps) == 1;
            }},
    Setting{"filter", "box, cone, hann, gaussian, mitchell, blackman_harris; box",
            "weight of the light around the middle of a pixel",
            [](ImageSettings& s, const Value& v) { s.render.filter.kind = filter_kind(v.text()); }},
    Setting{"radius", "0.5 to 16 pixels; 0.5", "of the filter",
            [](ImageSettings& s, const Value& v) {
                s.render.filter.radius = v.number(smallest_radius, largest_radius);
            }},
    Setting{"reconstruct", "importance, weighted, splat, splat_undivided; importance",
            "how samples make a pixel",
            [](ImageSettings& s, const Value& v) {
                s.render.reconstruction = reconstruction(v.text());
            }},
    Setting{"method", "whitted, path, irradiance; whitted", "which light is followed",
            [](ImageSettings& s, const Value& v) {
                s.render.transport.method = v.among<Method>(method_names);
            }},
    Setting{"rules", "spd, havran; spd", "of whitted: which normals decide on light",
            [](ImageSettings& s, const Value& v) {
                s.render.transport.rules = v.among<Rules>(rules_names);
            }},
    Setting{"depth", "1 to 255; 5 of whitted, else 32", "levels of the tree of rays",
            [](ImageSettings& s, const Value& v) {
                s.render.transport.depth = v.integer(1, largest_depth);
            }},
    Setting{"roulette", "1 to 255; 4", "of path: level from which rays are ended by chance",
            [](ImageSettings& s, const Value& v) {
                s.render.transport.roulette_level = v.integer(1, largest_depth);
            }},
    Setting{"gather", "1 to 65536; 256", "of irradiance: rays that make one record",
            [](ImageSettings& s, const Value& v) {
                s.render.transport.gather = v.integer(1, largest_gather);
            }},
    Setting{"cache_error", "0.001 to 1; 0.2", "of irradiance: how wrong an interpolation may be",
            [](ImageSettings& s, const Value& v) {
                s.render.transport.cache_error = v.real(0.001f, 1);
            }},
    Setting{"light_samples", "0 to 4096; 0",
            "shadow rays to each lamp of a size, at each hit; 0: as the scene says",
            [](ImageSettings& s, const Value& v) {
                s.render.transport.light_samples = v.integer(0, largest_light_samples);
            }},
    Setting{"lens", "f0.1 to f1000; the scene's", "f-number; the aperture is focal / f-number wide",
            [](ImageSettings& s, const Value& v) {
                const std::string_view text = v.text();
                const bool named = text.starts_with('f') || text.starts_with('F');
                s.f_stop = Value(text.substr(named ? 1 : 0)).real(0.1f, 1000);
            }},
    Setting{"focal", "scene units; 1/40 of focus", "focal length of the lens",
            [](ImageSettings& s, const Value& v) { s.focal_length = v.real(0, longest); }},
    Setting{"focus", "scene units; what the camera looks at", "distance of what is sharp",
            [](ImageSettings& s, const Value& v) { s.focus_distance = v.real(0, longest); }},
    Setting{"blades", "0, 3 to 64; 0", "corners of the aperture; 0: round",
            [](ImageSettings& s, const Value& v) { s.blades = v.integer(0, 64); }},
    Setting{"open", "0 to 1; 0", "ray time at which the shutter opens",
            [](ImageSettings& s, const Value& v) { s.shutter_open = v.real(0, 1); }},
    Setting{"close", "0 to 1; 1", "ray time at which it closes",
            [](ImageSettings& s, const Value& v) { s.shutter_close = v.real(0, 1); }},
    Setting{"shutter", "box, triangle, raised_cosine; box", "how long each moment counts",
            [](ImageSettings& s, const Value& v) { s.render.shutter = shutter_weight(v.text()); }},
    Setting{"tolerance", "0.0001 to 1; 1/255",
            "turns adaptive sampling on: wanted error of a pixel",
            [](ImageSettings& s, const Value& v) { adaptive(s).tolerance = v.number(1e-4, 1); }},
    Setting{
        "least", "2 to 65536; 16", "adaptive: samples of the first round",
        [](ImageSettings& s, const Value& v) { adaptive(s).least = v.integer(2, largest_spp); }},
    Setting{
        "round", "1 to 65536; 16", "adaptive: samples of each further round",
        [](ImageSettings& s, const Value& v) { adaptive(s).round = v.integer(1, largest_spp); }},
    Setting{"most", "2 to 65536; 256", "adaptive: samples of a pixel",
            [](ImageSettings& s, const Value& v) { adaptive(s).most = v.integer(2, largest_spp); }},
    Setting{"adaptive", "sequential, two_pass; sequential", "adaptive: cheap and biased, or not",
            [](ImageSettings& s, const Value& v) {
                adaptive(s).adaptation = v.among<Adaptation>(adaptations);
            }},
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Applies pairs of one text, however many pieces it comes in.
class Applier {
public:
    explicit Applier(ImageSettings& settings) : settings_(settings) {}

    void pairs(std::string_view text) {
        while (!text.empty()) {
            const std::size_t comma = std::min(text.find(','), text.size());
            pair(trimmed(text.substr(0, comma)));
            text.remove_prefix(std::min(comma + 1, text.size()));
        }
    }

private:
    void pair(std::string_view text) {
        const std::size_t equals = text.find('=');
        if (equals == std::string_view::npos)
            throw std::invalid_argument("setting '" + std::string(text) +
                                        "' is not of the form key=value");
        const std::string key(trimmed(text.substr(0, equals)));
        const auto found = std::ranges::find(settings_table, key, &Setting::key);
        if (found == settings_table.end()) {
            throw std::invalid_argument("there is no setting '" + key + "'; there are:\n" +
                                        describe_settings());
        }
        if (!given_.insert(key).second)
            throw std::invalid_argument("setting '" + key + "' is given twice");
        try {
            found->set(settings_, Value(trimmed(text.substr(equals + 1))));
        } catch (const std::invalid_argument& wrong) {
            throw std::invalid_argument("setting " + key + ": " + wrong.what());
        }
    }

    ImageSettings& settings_;
    std::set<std::string> given_;
};

void apply_file(const std::string& name, ImageSettings& settings) {
    std::istringstream file(read_file(name));
    Applier applier(settings);
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number) {
        try {
            applier.pairs(trimmed(std::string_view(line).substr(0, line.find('#'))));
        } catch (const std::invalid_argument& wrong) {
            throw std::invalid_argument(name + ":" + std::to_string(number) + ": " + wrong.what());
        }
    }
}

}  // namespace

void apply_settings(std::string_view text, ImageSettings& settings) {
    if (text.starts_with('@')) apply_file(std::string(text.substr(1)), settings);
    else Applier(settings).pairs(text);
}

void apply_to(Camera& camera, const ImageSettings& settings) {
    if (settings.shutter_open) camera.shutter_open = *settings.shutter_open;
    if (settings.shutter_close) camera.shutter_close = *settings.shutter_close;
    const bool lens =
        settings.f_stop || settings.focal_length || settings.focus_distance || settings.blades;
    if (!lens) return;
    if (!camera.lens) {
        if (!settings.f_stop)
            throw std::invalid_argument("this scene's camera has no lens; give lens=f2.8, say");
        camera.lens = lens_for(camera, *settings.f_stop);
    }
    if (settings.f_stop) camera.lens->f_stop = *settings.f_stop;
    if (settings.focus_distance) camera.lens->focus_distance = *settings.focus_distance;
    if (settings.focal_length) camera.lens->focal_length = *settings.focal_length;
    if (settings.blades) camera.lens->blades = *settings.blades;
    require_valid(*camera.lens);
}

std::string describe_settings() {
    std::string text;
    for (const Setting& setting : settings_table) {
        std::string line = "  " + std::string(setting.key) + "=";
        line.resize(std::max<std::size_t>(line.size(), 18), ' ');
        text += line + std::string(setting.meaning) + " (" + std::string(setting.accepts) + ")\n";
    }
    return text;
}

}  // namespace rayshoot
