// The bit rate that a client has set on a terminal, including nonstandard rates.
#pragma once

#include <cstdint>

namespace frob::serve {

// Returns 0 if the rate is unknown. Linux only. This function has its own file because its header
// conflicts with <termios.h>.
std::uint32_t terminal_rate(int descriptor);

} // namespace frob::serve
