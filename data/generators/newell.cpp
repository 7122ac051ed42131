#include "data/generators/newell.h"

#include <utility>

namespace rayshoot::procedural {

namespace {

/// A circle about the z axis, as control points of its quarters.
struct Ring {
    double radius, inner, z;  ///< inner: the smaller coordinate of a quarter's inner control points
};

/// A cross-section of handle or spout, half of it on either side of the plane y = 0.
struct Section {
    double x0, z0, x1, z1, half_width;
};

constexpr std::array rim{Ring{1.4, 0.784, 2.4}, Ring{1.3375, 0.749, 2.53125},
                         Ring{1.4375, 0.805, 2.53125}, Ring{1.5, 0.84, 2.4}};
constexpr std::array body{Ring{1.5, 0.84, 2.4}, Ring{1.75, 0.98, 1.875}, Ring{2, 1.12, 1.35},
                          Ring{2, 1.12, 0.9},   Ring{2, 1.12, 0.45},     Ring{1.5, 0.84, 0.225},
                          Ring{1.5, 0.84, 0.15}};
constexpr std::array lid{Ring{0, 0, 3.15},      Ring{0.8, 0.45, 3.15},  Ring{0, 0, 2.85},
                         Ring{0.2, 0.112, 2.7}, Ring{0.4, 0.224, 2.55}, Ring{1.3, 0.728, 2.55},
                         Ring{1.3, 0.728, 2.4}};
constexpr std::array bottom{Ring{0, 0, 0}, Ring{1.425, 0.798, 0}, Ring{1.5, 0.84, 0.075},
                            Ring{1.5, 0.84, 0.15}};

constexpr std::array handle{
    Section{-1.6, 2.025, -1.5, 2.25, 0.3}, Section{-2.3, 2.025, -2.5, 2.25, 0.3},
    Section{-2.7, 2.025, -3, 2.25, 0.3},   Section{-2.7, 1.8, -3, 1.8, 0.3},
    Section{-2.7, 1.575, -3, 1.35, 0.3},   Section{-2.5, 1.125, -2.65, 0.9375, 0.3},
    Section{-2, 0.9, -1.9, 0.6, 0.3}};
constexpr std::array spout{
    Section{1.7, 1.425, 1.7, 0.6, 0.66},       Section{2.6, 1.425, 3.1, 0.825, 0.66},
    Section{2.3, 2.1, 2.4, 2.025, 0.25},       Section{2.7, 2.4, 3.3, 2.4, 0.25},
    Section{2.8, 2.475, 3.525, 2.49375, 0.25}, Section{2.9, 2.475, 3.45, 2.5125, 0.15},
    Section{2.8, 2.4, 3.2, 2.4, 0.15}};

class Patches {
public:
    /// Four patches through four rings; quarters run from +x to `towards` * y and so on round.
    void revolve(std::span<const Ring, 4> rings, double towards) {
        dvec3 begin(1, 0, 0), end(0, towards, 0);
        for (int quarter = 0; quarter < 4; ++quarter) {
            Patch& patch = all_[count_++];
            for (std::size_t row = 0; row < 4; ++row) {
                const auto [radius, inner, z] = rings[row];
                const dvec3 height(0, 0, z);
                patch[row] = {radius * begin + height, radius * begin + inner * end + height,
                              inner * begin + radius * end + height, radius * end + height};
            }
            begin = std::exchange(end, -begin);
        }
    }

    /// Two patches through four cross-sections: the half with negative y, then its mirror image.
    void mirror(std::span<const Section, 4> sections) {
        Patch &half = all_[count_++], &image = all_[count_++];
        for (std::size_t row = 0; row < 4; ++row) {
            const auto [x0, z0, x1, z1, w] = sections[row];
            half[row] = {dvec3(x0, 0, z0), dvec3(x0, -w, z0), dvec3(x1, -w, z1), dvec3(x1, 0, z1)};
            image[row] = {dvec3(x1, 0, z1), dvec3(x1, w, z1), dvec3(x0, w, z0), dvec3(x0, 0, z0)};
        }
    }

    const std::array<Patch, 32>& all() const { return all_; }

private:
    std::array<Patch, 32> all_;
    std::size_t count_ = 0;
};

/// The patch's polynomials: coordinate i at (s, t) is (s^3, s^2, s, 1) * in[i] . (t^3, t^2, t, 1).
struct Polynomials {
    std::array<Matrix, 3> in;

    explicit Polynomials(const Patch& patch) {
        const Matrix bezier{{dvec4(-1, 3, -3, 1), {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}}};
        for (int axis = 0; axis < 3; ++axis) {
            Matrix control;
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column)
                    control[row][column] = patch[static_cast<std::size_t>(row)]
                                                [static_cast<std::size_t>(column)][axis];
            in[static_cast<std::size_t>(axis)] = bezier * control * bezier;  // it is symmetric
        }
    }

    dvec3 at(const dvec4& s_powers, const dvec4& t_powers) const {
        const auto value = [&](const Matrix& m) { return product(s_powers * m, t_powers); };
        return {value(in[0]), value(in[1]), value(in[2])};
    }

private:
    static double product(const dvec4& a, const dvec4& b) {
        return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    }
};

dvec4 powers(double s) { return {s * s * s, s * s, s, 1}; }
dvec4 powers_derived(double s) { return {s * s * 3, s * 2, 1, 0}; }

struct Vertex {
    dvec3 position, normal;

    bool on_axis() const {
        constexpr double tolerance = 1e-4;
        return std::abs(position.x) <= tolerance && std::abs(position.y) <= tolerance;
    }
};

Vertex vertex(const Polynomials& patch, double s, double t) {
    const dvec3 along_s = patch.at(powers_derived(s), powers(t));
    const dvec3 along_t = patch.at(powers(s), powers_derived(t));
    const dvec3 normal = glm::cross(along_t, along_s);
    Vertex result{patch.at(powers(s), powers(t)), normal == dvec3(0) ? normal : unit(normal)};
    // The tangents vanish in the middle of lid and bottom.
    if (result.on_axis()) result.normal = {0, 0, result.position.z > 1.5 ? 1 : -1};
    return result;
}

void print_triangle(Printer& printer, const Vertex& a, const Vertex& b, const Vertex& c) {
    if (a.on_axis() + b.on_axis() + c.on_axis() > 1) return;  // shrunk to a line
    printer.polygon(std::array{a.position, b.position, c.position},
                    std::array{a.normal, b.normal, c.normal});
}

}  // namespace

std::array<Patch, 32> newell_patches() {
    const auto four = [](const auto& rows, std::size_t first) {
        return std::span(rows).subspan(first).template first<4>();
    };
    Patches patches;
    patches.revolve(rim, -1);
    patches.revolve(four(body, 0), -1);
    patches.revolve(four(body, 3), -1);
    patches.mirror(four(handle, 0));
    patches.mirror(four(handle, 3));
    patches.mirror(four(spout, 0));
    patches.mirror(four(spout, 3));
    patches.revolve(four(lid, 0), -1);
    patches.revolve(four(lid, 3), -1);
    patches.revolve(bottom, 1);
    return patches.all();
}

void print_teapot(Printer& printer, int size) {
    for (const Patch& patch : newell_patches()) {
        const Polynomials polynomials(patch);
        const auto at = [&](int s, int t) {
            return vertex(polynomials, static_cast<double>(s) / size,
                          static_cast<double>(t) / size);
        };
        for (int s = 0; s < size; ++s)
            for (int t = 0; t < size; ++t) {
                const Vertex a = at(s, t), b = at(s, t + 1), c = at(s + 1, t + 1), d = at(s + 1, t);
                print_triangle(printer, a, b, c);
                print_triangle(printer, c, d, a);
            }
    }
}

}  // namespace rayshoot::procedural
