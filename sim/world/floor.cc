#include "floor.h"

#include <algorithm>

namespace frob::sim {
namespace {

// Computes the bounding box of some points, enlarged by `around` on all sides.
void enclose(const std::vector<Vec> &points, double around, Vec &low, Vec &high) {
    low = high = points.front();
    for (const Vec &p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    low = low - Vec{around, around};
    high = high + Vec{around, around};
}

// The fraction of the interval from `x - spot / 2` to `x + spot / 2` that is below `edge`.
double share_below(double edge, double x, double spot) {
    return std::clamp((edge - x) / spot + 0.5, 0.0, 1.0);
}

} // namespace

Floor::Layer Floor::area(const std::vector<Vec> &points, double reflectance) {
    Layer layer{points, true, true, 0.0, reflectance, {}, {}};
    enclose(points, 0.0, layer.low, layer.high);
    return layer;
}

Floor::Layer Floor::stripe(const Tape &tape) {
    Layer layer{tape.points, false, tape.closed, tape.width, tape.reflectance, {}, {}};
    enclose(tape.points, tape.width / 2, layer.low, layer.high);
    return layer;
}

Floor::Floor(const Scene &scene) : reflectance_(scene.floor.reflectance), holes_(scene.holes) {
    for (const Patch &patch : scene.patches)
        layers_.push_back(area(patch.points, patch.reflectance));
    for (const Tape &tape : scene.tapes) layers_.push_back(stripe(tape));
    for (const Hole &hole : scene.holes) layers_.push_back(area(hole.points, 0.0));
}

bool Floor::ends(Vec place) const {
    return std::any_of(holes_.begin(), holes_.end(),
                       [&](const Hole &hole) { return is_inside(hole.points, place); });
}

double Floor::reflectance(Vec place, double spot) const {
    double seen = reflectance_;
    for (const Layer &layer : layers_) {
        const double half = spot / 2;
        if (place.x < layer.low.x - half || place.x > layer.high.x + half ||
            place.y < layer.low.y - half || place.y > layer.high.y + half)
            continue;
        const double off = distance_to_polyline(layer.points, layer.closed, place);
        // For a stripe, both edges count, because the stripe may be narrower than the spot.
        const double covered =
            layer.outlined ? share_below(0.0, is_inside(layer.points, place) ? -off : off, spot)
                           : share_below(layer.width / 2, off, spot) -
                                 share_below(-layer.width / 2, off, spot);
        seen += covered * (layer.reflectance - seen);
    }
    return seen;
}

} // namespace frob::sim
