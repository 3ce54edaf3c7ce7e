// Cuts polygons into triangles, because Box2D's solids must be convex.
#pragma once

#include <array>
#include <vector>

#include "geometry.h"

namespace frob::sim {

using Triangle = std::array<Vec, 3>;

// The signed area of a polygon: half the sum of the cross products along the outline. Positive if
// the outline runs counter-clockwise.
double signed_area(const std::vector<Vec> &outline);

// Whether the outline is simple: no two edges cross or touch, except neighbours at their common
// point.
bool is_simple(const std::vector<Vec> &outline);

// Triangulates a simple counter-clockwise outline by ear clipping, in time quadratic in the number
// of points.
std::vector<Triangle> triangulate(std::vector<Vec> outline);

} // namespace frob::sim
