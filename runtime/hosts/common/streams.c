#include "streams.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

void streams_open(void)
{
    for (int number = STDIN_FILENO; number <= STDERR_FILENO; number++)
        if (fcntl(number, F_GETFD) < 0 && errno == EBADF)
            /* The lowest number that is free, opened for what nobody does with it. */
            if (open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY) != number)
                break;
    signal(SIGXFSZ, SIG_IGN);
}

bool streams_flush(void)
{
    errno = 0;
    if (fflush(stdout) == 0 && !ferror(stdout))
        return true;
    fprintf(stderr, "error: cannot write standard output: %s\n",
            errno != 0 ? strerror(errno) : "an error before");
    return false;
}
