// What a run of the simulated robot came to, for a person and for scripts.
#pragma once

#include "sim.h"

namespace frob::serve
{

// On standard output, one `name: value unit` a line, as frob-sim has it.
void print_summary(const frob_sim *sim);

} // namespace frob::serve
