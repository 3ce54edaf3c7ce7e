/* The rates for which POSIX or its implementations define constants. */
#include "hal/posix/parts.h"

#include <errno.h>
#include <termios.h>

static const struct {
    uint32_t bits_per_s;
    speed_t name;
} rates[] = {
    { 1200, B1200 },   { 2400, B2400 },     { 4800, B4800 },
    { 9600, B9600 },   { 19200, B19200 },   { 38400, B38400 },
    { 57600, B57600 }, { 115200, B115200 }, { 230400, B230400 },
};

int frob_posix_set_standard_rate(int fd, uint32_t bits_per_s)
{
    struct termios settings;
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        if (rates[i].bits_per_s == bits_per_s) {
            if (tcgetattr(fd, &settings) != 0 || cfsetispeed(&settings, rates[i].name) != 0 ||
                cfsetospeed(&settings, rates[i].name) != 0)
                return -1;
            return tcsetattr(fd, TCSADRAIN, &settings);
        }
    }
    errno = EINVAL;
    return -1;
}
