// The bit rate that a client has set on a terminal, including nonstandard rates.
#pragma once

#include <cstdint>

namespace frob::serve {

// Returns 0 if the rate is unknown. Linux only. This function is in its own file because the header
// that it needs conflicts with <termios.h>.
std::uint32_t terminal_rate(int descriptor);

} // namespace frob::serve
