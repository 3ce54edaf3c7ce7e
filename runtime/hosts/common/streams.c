#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* fopencookie */
#endif

#include "streams.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* ---- Control characters */

struct plain {
    int file;
    bool after_c2; /* UTF-8 encodes the control characters from 128 on as C2 80 to C2 9F */
};

static bool put_all(int file, const char *bytes, size_t size)
{
    while (size > 0) {
        const ssize_t put = write(file, bytes, size);
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0)
            return false;
        bytes += put;
        size -= (size_t)put;
    }
    return true;
}

/* Returns the number of bytes at the start that clear the line, so that a progress line can
 * overwrite itself. */
static size_t beginning(const char *bytes, size_t size)
{
    static const char clear[] = "\r\033[K";
    if (size >= sizeof clear - 1 && memcmp(bytes, clear, sizeof clear - 1) == 0)
        return sizeof clear - 1;
    return size > 0 && bytes[0] == '\r' ? 1 : 0;
}

static ssize_t put_plain(void *cookie, const char *bytes, size_t size)
{
    struct plain *plain = (struct plain *)cookie;
    char block[4096 + 8];
    size_t length = beginning(bytes, size);
    memcpy(block, bytes, length);
    for (size_t i = length; i < size; i++) {
        const unsigned char c = (unsigned char)bytes[i];
        const bool high = plain->after_c2 && c >= 0x80 && c < 0xa0;
        if (plain->after_c2 && !high)
            block[length++] = '\xc2';
        plain->after_c2 = c == 0xc2;
        if (high || (c < ' ' && c != '\n' && c != '\t') || c == 0x7f)
            length += (size_t)snprintf(block + length, 5, "\\%03u", (unsigned)c);
        else if (c != 0xc2)
            block[length++] = (char)c;
        if (length >= 4096 && !put_all(plain->file, block, length))
            return 0;
        if (length >= 4096)
            length = 0;
    }
    return put_all(plain->file, block, length) ? (ssize_t)size : 0;
}

static FILE *plain_stream(struct plain *plain, int file, int buffering)
{
    static const cookie_io_functions_t functions = { NULL, put_plain, NULL, NULL };
    FILE *stream;
    plain->file = file;
    stream = fopencookie(plain, "w", functions);
    if (stream != NULL)
        setvbuf(stream, NULL, buffering, BUFSIZ);
    return stream;
}

void streams_plain_output(void)
{
    static struct plain output;
    const bool is_terminal = isatty(STDOUT_FILENO) != 0;
    FILE *stream = output.file != 0
                       ? NULL
                       : plain_stream(&output, STDOUT_FILENO, is_terminal ? _IOLBF : _IOFBF);
    if (stream != NULL)
        stdout = stream;
}

void streams_keep_plain(void)
{
    static struct plain error;
    FILE *stream = plain_stream(&error, STDERR_FILENO, _IONBF);
    if (stream != NULL)
        stderr = stream;
    if (isatty(STDOUT_FILENO))
        streams_plain_output();
}

/* ---- All three streams */

void streams_open(void)
{
    for (int number = STDIN_FILENO; number <= STDERR_FILENO; number++)
        if (fcntl(number, F_GETFD) < 0 && errno == EBADF)
            /* open() returns the lowest free descriptor. The mode is the opposite of the stream's,
             * so that reading or writing the stream fails. */
            if (open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY) != number)
                break;
    signal(SIGXFSZ, SIG_IGN);
    streams_keep_plain();
}

bool streams_flush(void)
{
    errno = 0;
    if (fflush(stdout) == 0 && !ferror(stdout))
        return true;
    fprintf(stderr, "error: cannot write to standard output: %s\n",
            errno != 0 ? strerror(errno) : "an earlier write failed");
    return false;
}
