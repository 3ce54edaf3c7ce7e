#include "terminal.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "terminal_rate.h"

namespace frob::serve {

// Sets the terminal to raw mode, so that it does not echo bytes to the robot before a client has
// set raw mode itself.
Terminal::Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot create a pseudo-terminal");
    path_ = ptsname(master_);
    termios settings{};
    tcgetattr(master_, &settings);
    cfmakeraw(&settings);
    cfsetspeed(&settings, B9600);
    tcsetattr(master_, TCSANOW, &settings);
    // A terminal reports a hang-up only if its other side has been open before.
    const int once = open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (once >= 0) close(once);
}

Terminal::~Terminal() { close(master_); }

Bytes Terminal::read() {
    Bytes bytes(4096);
    pollfd state{master_, POLLIN, 0};
    poll(&state, 1, 0);
    connected_ = (state.revents & POLLHUP) == 0;
    const ssize_t count = ::read(master_, bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
}

void Terminal::write(const Bytes &bytes) {
    if (!connected_ || bytes.empty()) return;
    if (::write(master_, bytes.data(), bytes.size()) < 0 && errno == EIO) connected_ = false;
}

std::uint32_t Terminal::rate() const { return terminal_rate(master_); }

} // namespace frob::serve
