// The rate that a client has set on a terminal, whatever it is.
#pragma once

#include <cstdint>

namespace frob::serve
{

// 0 if it cannot be told. Linux; apart because its header cannot be included
// beside <termios.h>.
std::uint32_t terminal_rate(int descriptor);

} // namespace frob::serve
