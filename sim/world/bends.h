// Replaces the corners of a polyline with arcs, the way tape is laid.
#pragma once

#include <optional>
#include <vector>

#include "geometry.h"

namespace frob::sim {

// Returns the first corner at which an arc of this radius does not fit, or no value if it fits
// everywhere. It does not fit if two arcs need more space than the segment between them has, if it
// would extend past a free end, or if the line turns back on itself.
std::optional<Vec> corner_without_room(const std::vector<Vec> &points, bool closed, double radius);

// Returns the polyline with an arc of this radius at each corner. Arcs consist of pieces of at most
// 5 degrees, which deviate from the arc by less than a thousandth of the radius.
std::vector<Vec> with_bends(const std::vector<Vec> &points, bool closed, double radius);

} // namespace frob::sim
