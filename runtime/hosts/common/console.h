/* console.h -- keys as they are typed, from standard input. */
#ifndef FROB_HOST_CONSOLE_H
#define FROB_HOST_CONSOLE_H

#include <stdbool.h>
#include <stdint.h>
#include <termios.h>

struct console {
    bool open;
    bool is_terminal;
    struct termios before; /* how the terminal was */
};

/* From now on a terminal gives each key at once and does not show it. */
void console_open(struct console *console);

/* The character code of the next key that was typed, -1 if there is none, or if
 * the console is not open. Does not wait. */
int32_t console_key(struct console *console);

/* The terminal is as before. */
void console_close(struct console *console);

#endif
