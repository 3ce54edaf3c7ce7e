#include "triangulate.h"

#include <algorithm>

namespace frob::sim {
namespace {

double turn(Vec a, Vec b, Vec c) { return cross(b - a, c - b); }

bool segments_touch(Vec a, Vec b, Vec c, Vec d) {
    const auto sign = [](double x) { return x > 0.0 ? 1 : x < 0.0 ? -1 : 0; };
    const auto on = [](Vec p, Vec q, Vec r) { // whether r is on pq, given that it is on the
                                              // line through p and q
        return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) &&
               std::min(p.y, q.y) <= r.y && r.y <= std::max(p.y, q.y);
    };
    const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d));
    const int cda = sign(turn(c, d, a)), cdb = sign(turn(c, d, b));
    if (abc != abd && cda != cdb) return true;
    return (abc == 0 && on(a, b, c)) || (abd == 0 && on(a, b, d)) || (cda == 0 && on(c, d, a)) ||
           (cdb == 0 && on(c, d, b));
}

bool inside(const Triangle &t, Vec p) {
    return turn(t[0], t[1], p) >= 0.0 && turn(t[1], t[2], p) >= 0.0 && turn(t[2], t[0], p) >= 0.0;
}

// Whether the corner at `i` can be cut off: it must be convex, and its triangle must not
// contain any other point.
bool is_ear(const std::vector<Vec> &outline, std::size_t i) {
    const std::size_t n = outline.size();
    const Triangle ear = {outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]};
    if (turn(ear[0], ear[1], ear[2]) <= 0.0) return false;
    for (std::size_t j = 2; j + 1 < n; ++j)
        if (inside(ear, outline[(i + j) % n])) return false;
    return true;
}

} // namespace

double signed_area(const std::vector<Vec> &outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        twice += cross(outline[i], outline[(i + 1) % outline.size()]);
    return 0.5 * twice;
}

bool is_simple(const std::vector<Vec> &outline) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j)
            if (!(i == 0 && j == n - 1) &&
                segments_touch(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n]))
                return false;
    return signed_area(outline) != 0.0;
}

std::vector<Triangle> triangulate(std::vector<Vec> outline) {
    std::vector<Triangle> triangles;
    while (outline.size() > 3) {
        const std::size_t n = outline.size();
        // A simple polygon has at least two ears. A point on a straight edge forms a corner of zero
        // area, which is removed without adding a triangle.
        std::size_t i = 0;
        while (i < n && !is_ear(outline, i) &&
               turn(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]) != 0.0)
            ++i;
        if (i == n) break;
        const Triangle ear = {outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]};
        if (turn(ear[0], ear[1], ear[2]) > 0.0) triangles.push_back(ear);
        outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
    }
    triangles.push_back({outline[0], outline[1], outline[2]});
    return triangles;
}

} // namespace frob::sim
