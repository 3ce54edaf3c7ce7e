// Plane geometry in metres and radians: x east, y north, angles
// counter-clockwise from x. Double precision; Box2D's floats stay in world.cc
// and drive.cc.
#pragma once

#include <cmath>

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
inline double length(Vec a) { return std::hypot(a.x, a.y); }
inline Vec direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

struct Pose {
    Vec position;
    double heading = 0.0;
};

// A point given in the frame of `frame`, in the frame that `frame` is given in.
inline Vec from_frame(const Pose &frame, Vec point) {
    const Vec u = direction(frame.heading);
    return frame.position + Vec{u.x * point.x - u.y * point.y, u.y * point.x + u.x * point.y};
}

inline Pose from_frame(const Pose &frame, const Pose &pose) {
    return {from_frame(frame, pose.position), frame.heading + pose.heading};
}

// The same angle in (-pi, pi].
inline double wrap_angle(double angle) {
    const double wrapped = std::remainder(angle, 2.0 * pi);
    return wrapped <= -pi ? pi : wrapped;
}

// Distance from `p` to the segment from `a` to `b`.
inline double distance_to_segment(Vec p, Vec a, Vec b) {
    const Vec along = b - a;
    const double squared = dot(along, along);
    const double t = squared > 0.0 ? dot(p - a, along) / squared : 0.0;
    const double clamped = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return length(p - (a + clamped * along));
}

} // namespace frob::sim
