// Plane geometry in metres and radians: x east, y north, angles counter-clockwise from x. Double
// precision; only world.cc and drive.cc use Box2D's floats.
#pragma once

#include <cmath>
#include <vector>

namespace frob::sim {

constexpr double pi = 3.14159265358979323846;

constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

struct Vec {
    double x = 0.0;
    double y = 0.0;
};

constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec operator*(double k, Vec a) { return {k * a.x, k * a.y}; }
constexpr double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

// `v` turned by a small angle, such as the robot's turn in a physics step. Sums the series
// for sine and cosine up to e^4, which is accurate to 3e-10 for |e| <= 0.03. This function runs in
// every step, and is several times faster than the library's functions.
constexpr Vec turned_a_little(Vec v, double e) {
    const double squared = e * e;
    const double c = 1.0 - squared / 2 * (1.0 - squared / 12), s = e * (1.0 - squared / 6);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

struct Pose {
    Vec position;
    double heading = 0.0;
};

// Converts a point from the coordinates of `frame` to the coordinates in which `frame` itself is
// given.
inline Vec from_frame(const Pose &frame, Vec point) {
    const Vec u = direction(frame.heading);
    return frame.position + Vec{u.x * point.x - u.y * point.y, u.y * point.x + u.x * point.y};
}

inline Pose from_frame(const Pose &frame, const Pose &pose) {
    return {from_frame(frame, pose.position), frame.heading + pose.heading};
}

// The equivalent angle in (-pi, pi].
inline double wrap_angle(double angle) {
    if (-pi < angle && angle <= pi) return angle;
    const double wrapped = std::remainder(angle, 2.0 * pi);
    return wrapped <= -pi ? pi : wrapped;
}

// Squared distance from `p` to the segment from `a` to `b`.
inline double squared_distance_to_segment(Vec p, Vec a, Vec b) {
    const Vec along = b - a;
    const double squared = dot(along, along);
    const double t = squared > 0.0 ? dot(p - a, along) / squared : 0.0;
    const double clamped = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    const Vec apart = p - (a + clamped * along);
    return dot(apart, apart);
}

// Distance from `p` to a polyline; if it is closed, the last point is joined to the first.
double distance_to_polyline(const std::vector<Vec> &points, bool closed, Vec p);

// Whether a point is inside a polygon.
bool is_inside(const std::vector<Vec> &outline, Vec p);

} // namespace frob::sim
