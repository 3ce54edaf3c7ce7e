// The colours in the picture of a run.
#pragma once

#include "canvas.h"

namespace frob::sim::palette {

constexpr Colour paper{255, 255, 255};
constexpr Colour floor{248, 249, 251};
constexpr Colour black_floor{58, 60, 66};
constexpr Colour lamp{242, 190, 40};
constexpr Colour lamp_edge{176, 128, 12};
constexpr Colour grid{228, 231, 236};
constexpr Colour frame{196, 201, 209};
constexpr Colour ink{40, 44, 52};
constexpr Colour faint_ink{118, 125, 137};

constexpr Colour solid{71, 80, 97};
constexpr Colour hole{214, 219, 228};
constexpr Colour hole_edge{140, 148, 163};
constexpr Colour box{226, 183, 107};
constexpr Colour box_edge{158, 117, 41};

constexpr Colour early{150, 198, 231}; // the start of the path
constexpr Colour late{16, 74, 142};    // the end of the path
constexpr Colour believed{139, 95, 191};

constexpr Colour robot{238, 108, 77};
constexpr Colour robot_edge{122, 42, 22};
constexpr Colour sonar{20, 150, 136};

constexpr Colour truth{16, 74, 142};
constexpr Colour command{238, 108, 77};
constexpr Colour target{90, 96, 108};

constexpr Colour faded(Colour c, double opacity) { return {c.red, c.green, c.blue, opacity}; }

} // namespace frob::sim::palette
