#include "geometry.h"

namespace frob::sim {

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
