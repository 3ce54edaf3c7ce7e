// Geometry in space, in metres: x and y along the floor, z up. It uses only operations that IEEE
// 754 defines to the last bit, and its own sine and cosine, so that a scene produces the same
// picture on every machine.
#pragma once

#include <cmath>

#include "geometry.h"

namespace frob::sim {

struct Point {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point operator*(double k, Point a) { return {k * a.x, k * a.y, k * a.z}; }
constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Point cross(Point a, Point b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline Point unit(Point a) { return (1.0 / length(a)) * a; }
constexpr Point at_height(Vec v, double z) { return {v.x, v.y, z}; }

// Cosine and sine of an angle. Subtracts whole quarter turns, then sums the series up to the 16th
// power, which is accurate to 1e-14 within an eighth of a turn either way.
inline Vec exact_direction(double angle) {
    const double quarters = std::floor(angle / (pi / 2) + 0.5);
    const double a = angle - quarters * (pi / 2), squared = a * a;
    double c = 1.0, s = 1.0;
    for (int k = 16; k >= 2; k -= 2) {
        c = 1.0 - squared / (k * (k - 1)) * c;
        s = 1.0 - squared / (k * (k + 1)) * s;
    }
    s *= a;
    switch (static_cast<long long>(quarters) & 3) {
    case 0: return {c, s};
    case 1: return {-s, c};
    case 2: return {-c, -s};
    default: return {s, -c};
    }
}

} // namespace frob::sim
