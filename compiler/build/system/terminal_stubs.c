/* The size of the terminal. See terminal.mli. */
#include <caml/mlvalues.h>

#include <sys/ioctl.h>
#include <unistd.h>

value frob_terminal_columns(value unit)
{
    struct winsize size;
    (void)unit;
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0)
        return Val_int(0);
    return Val_int(size.ws_col);
}
