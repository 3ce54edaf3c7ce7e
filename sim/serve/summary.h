// The summary of a run, readable by people and scripts.
#pragma once

#include "sim.h"

namespace frob::serve {

// Prints it to standard output, one `name: value unit` a line, as frob-sim does.
void print_summary(const frob_sim *sim);

} // namespace frob::serve
