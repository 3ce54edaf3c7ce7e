// Round bends in the place of a polyline's corners, as tape is laid.
#pragma once

#include <optional>
#include <vector>

#include "geometry.h"

namespace frob::sim
{

// The first corner where a bend of this radius has no room: two bends would need
// more than the segment between them, or one would begin before a free end or end
// behind it, or the line turns back. No value: there is room at each.
std::optional<Vec> corner_without_room(const std::vector<Vec> &points, bool closed, double radius);

// The polyline with an arc of this radius at each corner, in pieces of at most
// 5 degrees: a piece is off the arc by less than a thousandth of the radius.
std::vector<Vec> with_bends(const std::vector<Vec> &points, bool closed, double radius);

} // namespace frob::sim
