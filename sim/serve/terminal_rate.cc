#include "terminal_rate.h"

#include <asm/ioctls.h>
#include <asm/termbits.h>

// Declared here because <sys/ioctl.h> would declare a conflicting struct termios.
extern "C" int ioctl(int descriptor, unsigned long request, ...) noexcept;

std::uint32_t frob::serve::terminal_rate(int descriptor) {
    termios2 settings{};
    return ioctl(descriptor, TCGETS2, &settings) == 0 ? settings.c_ospeed : 0;
}
