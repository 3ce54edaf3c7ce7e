// The measures of Nomadics' Super Scout. Sources, and what is only estimated:
// stdlib/Scout.frob, whose numbers these are.
#pragma once

#include "chassis.h"
#include "sonar_ring.h"

namespace frob::sim::super_scout
{

constexpr std::size_t sonar_count = 16, bumper_count = 6;

const Chassis &chassis();
const SonarRing &ring();

} // namespace frob::sim::super_scout
