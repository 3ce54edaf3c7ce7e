#include "console.h"

#include <poll.h>
#include <unistd.h>

void console_open(struct console *console)
{
    console->open = true;
    console->is_terminal = tcgetattr(STDIN_FILENO, &console->before) == 0;
    if (console->is_terminal) {
        struct termios keys = console->before;
        keys.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
        tcsetattr(STDIN_FILENO, TCSANOW, &keys);
    }
}

int32_t console_key(struct console *console)
{
    struct pollfd input = { STDIN_FILENO, POLLIN, 0 };
    unsigned char key;
    if (!console->open || poll(&input, 1, 0) <= 0 || (input.revents & (POLLIN | POLLHUP)) == 0)
        return -1;
    if (read(STDIN_FILENO, &key, 1) == 1)
        return key;
    console->open = false; /* end of the input */
    if (console->is_terminal)
        tcsetattr(STDIN_FILENO, TCSANOW, &console->before);
    return -1;
}

void console_close(struct console *console)
{
    if (console->open && console->is_terminal)
        tcsetattr(STDIN_FILENO, TCSANOW, &console->before);
    console->open = false;
}
