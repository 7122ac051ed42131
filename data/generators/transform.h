#pragma once

#include "data/scene.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>

/// Affine maps in double, for row vectors: a point p goes to p * first * second.
/// The order of every sum is part of the scenes: it decides the residues that are printed as 6e-17.
namespace rayshoot::procedural {

using glm::dvec4;

struct Matrix {
    std::array<dvec4, 4> rows{dvec4{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

    dvec4& operator[](int row) { return rows[static_cast<std::size_t>(row)]; }
    const dvec4& operator[](int row) const { return rows[static_cast<std::size_t>(row)]; }
};

inline dvec4 operator*(const dvec4& v, const Matrix& m) {
    return v.x * m[0] + v.y * m[1] + v.z * m[2] + v.w * m[3];
}

inline Matrix operator*(const Matrix& first, const Matrix& second) {
    return {{first[0] * second, first[1] * second, first[2] * second, first[3] * second}};
}

inline dvec3 point(const dvec3& p, const Matrix& m) { return dvec3(dvec4(p, 1) * m); }
inline dvec3 direction(const dvec3& d, const Matrix& m) { return dvec3(dvec4(d, 0) * m); }

inline dvec3 unit(const dvec3& v) { return v / std::sqrt(glm::dot(v, v)); }

inline Matrix scaling(double factor) {
    Matrix m;
    for (int axis = 0; axis < 3; ++axis) m[axis][axis] = factor;
    return m;
}

inline Matrix translation(const dvec3& offset) {
    Matrix m;
    m[3] = dvec4(offset, 1);
    return m;
}

enum Axis { x_axis, y_axis, z_axis };

/// Right-handed, about a coordinate axis, by radians.
inline Matrix rotation(Axis axis, double angle) {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    Matrix m;
    m[next][next] = m[last][last] = std::cos(angle);
    m[next][last] = std::sin(angle);
    m[last][next] = -m[next][last];
    return m;
}

/// Right-handed, about a unit vector, by radians.
inline Matrix rotation(const dvec3& axis, double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    Matrix m;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        m[i][i] = axis[i] * axis[i] + (1 - axis[i] * axis[i]) * cosine;
        m[i][j] = axis[i] * axis[j] * (1 - cosine) + axis[k] * sine;
        m[j][i] = axis[i] * axis[j] * (1 - cosine) - axis[k] * sine;
    }
    return m;
}

}  // namespace rayshoot::procedural
