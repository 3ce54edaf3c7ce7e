#include "bends.h"

#include <algorithm>
#include <cmath>

namespace frob::sim {
namespace {

constexpr double piece = radians(5.0);
constexpr double sharpest = radians(175.0);

// A corner of a polyline, with the points before and after it.
struct Corner {
    Vec before, here, after;

    Vec in() const { return (1.0 / length(here - before)) * (here - before); }
    Vec out() const { return (1.0 / length(after - here)) * (after - here); }
    double turn() const { return std::atan2(cross(in(), out()), dot(in(), out())); }
    // The distance from the corner to the two ends of an arc that is tangent to both sides.
    double reach(double radius) const { return radius * std::tan(std::abs(turn()) / 2); }
};

// Free ends are not corners.
std::vector<Corner> corners_of(const std::vector<Vec> &points, bool closed) {
    std::vector<Corner> corners;
    const std::size_t n = points.size();
    for (std::size_t i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i)
        corners.push_back({points[(i + n - 1) % n], points[i], points[(i + 1) % n]});
    return corners;
}

void add_bend(const Corner &corner, double radius, std::vector<Vec> &to) {
    const double turn = corner.turn(), reach = corner.reach(radius);
    const Vec begin = corner.here - reach * corner.in();
    const double side = turn < 0.0 ? -1.0 : 1.0; // in a left turn, the centre is on the left
    const Vec in = corner.in();
    const Vec middle = begin + side * radius * Vec{-in.y, in.x};
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / piece)));
    for (int k = 0; k <= pieces; ++k) {
        const double angle = turn * k / pieces;
        const Vec arm = begin - middle;
        to.push_back(middle + Vec{std::cos(angle) * arm.x - std::sin(angle) * arm.y,
                                  std::sin(angle) * arm.x + std::cos(angle) * arm.y});
    }
}

} // namespace

std::optional<Vec> corner_without_room(const std::vector<Vec> &points, bool closed, double radius) {
    const std::vector<Corner> corners = corners_of(points, closed);
    const std::size_t n = corners.size();
    // The length that the arc of a corner needs on each of its two segments. A free end needs none.
    const auto needed = [&](std::size_t i) { return corners[i % n].reach(radius); };
    for (std::size_t i = 0; i < n; ++i) {
        const Corner &corner = corners[i];
        if (std::abs(corner.turn()) > sharpest) return corner.here;
        const double before = closed || i > 0 ? needed(i + n - 1) : 0.0;
        const double after = closed || i + 1 < n ? needed(i + 1) : 0.0;
        if (needed(i) + before > length(corner.here - corner.before) ||
            needed(i) + after > length(corner.after - corner.here))
            return corner.here;
    }
    return std::nullopt;
}

std::vector<Vec> with_bends(const std::vector<Vec> &points, bool closed, double radius) {
    std::vector<Vec> bent;
    if (!closed) bent.push_back(points.front());
    for (const Corner &corner : corners_of(points, closed)) add_bend(corner, radius, bent);
    if (!closed) bent.push_back(points.back());
    return bent;
}

} // namespace frob::sim
