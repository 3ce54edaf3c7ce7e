// Polygons cut into triangles: Box2D's solids are convex.
#pragma once

#include <array>
#include <vector>

#include "geometry.h"

namespace frob::sim
{

using Triangle = std::array<Vec, 3>;

// Twice the area is the sum of the cross products along the outline; positive
// if it runs counter-clockwise.
double signed_area(const std::vector<Vec> &outline);

// No two edges cross or touch, but neighbours at their common point.
bool is_simple(const std::vector<Vec> &outline);

// Takes a simple counter-clockwise outline. Method: ear clipping, quadratic in
// the number of points.
std::vector<Triangle> triangulate(std::vector<Vec> outline);

} // namespace frob::sim
