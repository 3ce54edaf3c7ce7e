#include "geometry.h"

#include <algorithm>
#include <limits>

namespace frob::sim {

double distance_to_polyline(const std::vector<Vec> &points, bool closed, Vec p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        nearest = std::min(nearest, squared_distance_to_segment(p, points[i], points[i + 1]));
    if (closed)
        nearest = std::min(nearest, squared_distance_to_segment(p, points.back(), points.front()));
    return std::sqrt(nearest);
}

// Counts the edges that a ray to the right crosses.
bool is_inside(const std::vector<Vec> &outline, Vec p) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec a = outline[i], b = outline[(i + 1) % outline.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

} // namespace frob::sim
