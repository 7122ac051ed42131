#include "data/aff_file.h"

#include "data/aff_keys.h"
#include "data/animation.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace rayshoot {
namespace {

// A scene of nested includes doubles with each level; no real one comes near this.
constexpr std::size_t most_bytes = std::size_t{1} << 30;
constexpr Lexis lexis{.comments = "#%", .alone = "{}"};

/// AFF's colours for diffuse and specular, as NFF's colour and shares.
Material material_of(const vec3& diffuse, const vec3& specular) {
    Material material;
    material.diffuse = std::max({diffuse.x, diffuse.y, diffuse.z});
    material.colour = material.diffuse > 0 ? diffuse / material.diffuse : vec3(1);
    material.specular = (specular.x + specular.y + specular.z) / 3;
    return material;
}

}  // namespace

AffFile::AffFile(AffReading& reading, std::string text, const std::string& path,
                 const std::string& name, std::uint32_t around)
    : reading_(reading),
      text_(std::move(text)),
      path_(path),
      tokens_(text_, name, lexis),
      transforms_{around},
      first_time_(reading.seen.insert(path).second) {
    reading_.model.counts.files += first_time_;
}

void AffFile::read() {
    for (std::string_view word = tokens_.next(); !word.empty(); word = tokens_.next()) entity(word);
    if (transforms_.size() > 1) tokens_.refuse("the file ends in a transform; close it by }");
}

void AffFile::entity(std::string_view keyword) {
    AffModel& model = reading_.model;
    if (shape(keyword)) return;
    if (keyword == "v") return read_view(tokens_, model.camera.emplace());
    if (keyword == "b") {
        model.background = tokens_.three("background: b red green blue");
        return;
    }
    if (keyword == "l") return light(false);
    if (keyword == "la") return light(true);
    if (keyword == "f") return model.materials.push_back(read_fill(tokens_));
    if (keyword == "fm") return fill_by_colours();
    if (keyword == "am") {
        tokens_.three("ambient light: am red green blue");
        return leave_out("ambient light");
    }
    if (keyword == "a") return animation();
    if (keyword == "d") {
        reading_.detail = static_cast<int>(tokens_.integer("level of detail", 0, 1000));
        return;
    }
    if (keyword == "i") return include();
    if (keyword == "xs") return open_static();
    if (keyword == "x") return open_animated();
    if (keyword == "}") return close();
    if (keyword == "k") return key_frames();
    if (parse_number(keyword))
        tokens_.refuse("a number too many: " + quoted(keyword) +
                       " stands where an entity begins; check the counts above it");
    tokens_.refuse("unknown entity " + quoted(keyword) +
                   "; AFF has v, b, l, la, f, fm, am, a, d, i, s, c, p, pp, t, tt, ttp, tpa, m, "
                   "xs, x, k, and # and % for comments");
}

void AffFile::light(bool with_key_frames) {
    AffLight light;
    if (with_key_frames) light.key_frames = tokens_.next();
    light.position = tokens_.three("light: l x y z [red green blue]");
    if (parse_number(tokens_.peek()))
        light.colour = tokens_.three("colour of a light: red green blue");
    light.transform = transforms_.back();
    reading_.model.lights.push_back(std::move(light));
    reading_.model.counts.lights += first_time_;
}

void AffFile::fill_by_colours() {
    constexpr std::string_view use =
        "material: fm ambient, diffuse and specular red green blue, shine T index_of_refraction";
    const auto colour = [&] {
        const float red = at_least_zero(tokens_, use), green = at_least_zero(tokens_, use);
        return vec3(red, green, at_least_zero(tokens_, use));
    };
    colour();  // ambient
    const vec3 diffuse = colour();
    Material material = material_of(diffuse, colour());
    material.shininess = at_least_zero(tokens_, use);
    material.transmittance = at_least_zero(tokens_, use);
    const float index = at_least_zero(tokens_, use);
    material.refraction_index = index > 0 ? index : 1;  // 0 stands for "lets nothing through"
    reading_.model.materials.push_back(material);
}

void AffFile::animation() {
    constexpr std::string_view use = "animation: a first_time last_time frames";
    AffAnimation& animation = reading_.model.animation;
    animation.start = tokens_.number(use);
    animation.end = tokens_.number(use);
    if (animation.end < animation.start) tokens_.refuse("the animation ends before it begins");
    animation.frames = static_cast<int>(tokens_.integer(use, 1, most_frames));
}

void AffFile::include() {
    const auto level = tokens_.integer("include: i level_of_detail file", 0, 1000);
    const std::filesystem::path given = tokens_.next();
    if (given.empty()) tokens_.refuse("the name of the included file is missing");
    if (given.is_absolute()) tokens_.refuse("includes are relative to the file that has them");
    if (level > reading_.detail) return;
    const std::string path =
        (std::filesystem::path(path_).parent_path() / given).lexically_normal().generic_string();
    if (std::ranges::find(reading_.open, path) != reading_.open.end())
        tokens_.refuse(rayshoot::quoted(path) + " includes itself; break the circle");
    std::string text;
    try {
        text = reading_.files(path);
    } catch (const std::invalid_argument& error) {
        tokens_.refuse(error.what());
    }
    reading_.bytes += text.size() + 1;
    if (reading_.bytes > most_bytes) tokens_.refuse("the includes come to more than 1 GiB");
    reading_.open.push_back(path);
    AffFile(reading_, std::move(text), path, path, transforms_.back()).read();
    reading_.open.pop_back();
}

void AffFile::open(std::variant<glm::dmat4, std::string> own, const std::string& where) {
    expect_brace();
    std::vector<AffTransform>& all = reading_.model.transforms;
    all.push_back({transforms_.back(), std::move(own), where});
    transforms_.push_back(static_cast<std::uint32_t>(all.size() - 1));
}

void AffFile::open_static() {
    constexpr std::string_view use =
        "static transform: xs scale x y z, axis x y z, degrees, shift x y z";
    const std::string where = tokens_.where();
    const dvec3 scale(tokens_.three(use));
    const glm::dquat rotation = read_rotation(tokens_, use);
    const dvec3 shift(tokens_.three(use));
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), shift) * glm::mat4_cast(rotation);
    reading_.model.counts.static_transforms += first_time_;
    open(glm::scale(moved, scale), where);
}

void AffFile::open_animated() {
    const std::string where = tokens_.where();
    const std::string name(tokens_.next());
    reading_.model.counts.animated_transforms += first_time_;
    open(name, where);
}

void AffFile::close() {
    if (transforms_.size() == 1) tokens_.refuse("a } without a transform that it closes");
    transforms_.pop_back();
}

void AffFile::key_frames() {
    const std::string name(tokens_.next());
    expect_brace();
    KeyFrames frames = read_key_frames(tokens_);
    reading_.model.counts.key_frames += first_time_;
    const bool added = reading_.model.key_frames.emplace(name, std::move(frames)).second;
    if (!added && first_time_)
        tokens_.refuse("a second set of key frames for " + rayshoot::quoted(name) + "; keep one");
}

void AffFile::expect_brace() {
    if (const std::string_view word = tokens_.next(); word != "{")
        tokens_.refuse(quoted(word) + " where { is expected");
}

AffModel read_aff_model(std::string text, const std::string& name, const AffFiles& files) {
    AffReading reading(files);
    const std::string path = std::filesystem::path(name).filename().generic_string();
    reading.open.push_back(path);
    AffFile(reading, std::move(text), path, name, 0).read();
    return std::move(reading.model);
}

}  // namespace rayshoot
