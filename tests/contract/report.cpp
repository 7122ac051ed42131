#include "tests/contract/report.h"

#include <bit>
#include <cstdio>
#include <ostream>

namespace rayshoot::contract {
namespace {

constexpr std::size_t messages_kept = 8;

std::string hex(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%a", static_cast<double>(value));
    return text;
}

std::string hex(const vec3& value) {
    std::string text = "(";
    return text.append(hex(value.x) + ", ").append(hex(value.y) + ", ").append(hex(value.z) + ")");
}

}  // namespace

void Report::fail(std::string message) {
    ++failures;
    if (messages.size() < messages_kept) messages.push_back(std::move(message));
}

Report& Report::operator+=(const Report& other) {
    scenes += other.scenes;
    refused += other.refused;
    answers += other.answers;
    failures += other.failures;
    for (const std::string& message : other.messages)
        if (messages.size() < messages_kept) messages.push_back(message);
    return *this;
}

std::ostream& operator<<(std::ostream& out, const Report& report) {
    out << report.answers << " answers on " << report.scenes << " scenes (" << report.refused
        << " refused): " << report.failures << " failures\n";
    for (const std::string& message : report.messages) out << "  " << message << '\n';
    if (report.failures > report.messages.size())
        out << "  and " << report.failures - report.messages.size() << " more\n";
    return out;
}

std::string printed(const Ray& ray) {
    return "ray{" + hex(ray.origin) + ", t_min " + hex(ray.t_min) + ", " + hex(ray.direction) +
           ", t_max " + hex(ray.t_max) + ", time " + hex(ray.time) + "}";
}

std::string printed(const Hit& hit) {
    const std::string primitive =
        hit.primitive == no_primitive ? "none" : std::to_string(hit.primitive);
    return "hit{" + hex(hit.t) + ", " + primitive + ", " + hex(hit.u) + ", " + hex(hit.v) + "}";
}

bool same_bits(const Hit& a, const Hit& b) {
    const auto same = [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    };
    return same(a.t, b.t) && a.primitive == b.primitive && same(a.u, b.u) && same(a.v, b.v);
}

}  // namespace rayshoot::contract
