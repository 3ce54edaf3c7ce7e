// Dimensions of Nomadics' Super Scout. The values are the same as in stdlib/Scout.frob, which lists
// the sources and says which values are estimates.
#pragma once

#include "chassis.h"
#include "sonar_ring.h"

namespace frob::sim::super_scout {

constexpr std::size_t sonar_count = 16, bumper_count = 6;

const Chassis &chassis();
const SonarRing &ring();

} // namespace frob::sim::super_scout
