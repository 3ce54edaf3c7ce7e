/* console.h -- reads keys from standard input as they are typed. */
#ifndef FROB_HOST_CONSOLE_H
#define FROB_HOST_CONSOLE_H

#include <stdbool.h>
#include <stdint.h>
#include <termios.h>

struct console {
    bool open;
    bool is_terminal;
    struct termios before; /* settings to restore */
};

/* Sets a terminal to deliver each key immediately and not to echo it. */
void console_open(struct console *console);

/* Returns the character code of the next typed key; -1 if there is none, or if the console is not
 * open. Does not wait. */
int32_t console_key(struct console *console);

/* Restores the terminal. */
void console_close(struct console *console);

#endif
