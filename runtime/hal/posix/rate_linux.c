/* Sets any bit rate with Linux's own struct termios2, whose header cannot be included together with
 * <termios.h>. Emulators of Linux may not support this struct. */
#include "hal/posix/parts.h"

#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <errno.h>

/* <sys/ioctl.h> contains this declaration too, but may include <termios.h>. */
extern int ioctl(int fd, unsigned long request, ...);

int frob_posix_set_terminal_rate(int fd, uint32_t bits_per_s)
{
    struct termios2 settings;
    if (ioctl(fd, TCGETS2, &settings) != 0)
        return errno == ENOSYS ? frob_posix_set_standard_rate(fd, bits_per_s) : -1;
    settings.c_cflag &= ~(tcflag_t)(CBAUD | CBAUD << IBSHIFT);
    settings.c_cflag |= BOTHER | BOTHER << IBSHIFT;
    settings.c_ispeed = bits_per_s;
    settings.c_ospeed = bits_per_s;
    return ioctl(fd, TCSETSW2, &settings);
}
