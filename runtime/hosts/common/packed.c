#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* fopencookie, vfork */
#endif

#include "packed.h"

#include "child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* Errors that the system does not define, represented by unused errno values. */
enum { NOT_INSTALLED = ENOPKG, CUT_OFF = EBADMSG, OTHER_FORMAT = EILSEQ, IS_MCAP = EPROTO };

static const struct format {
    const char *tool, *ending;
    const char *magic;   /* the first bytes of a file in this format */
    const char *packing; /* options of the tool; without -n, gzip would store the time */
} formats[] = {
    { "gzip", ".gz", "\x1f\x8b", "-cqn" },
    { "zstd", ".zst", "\x28\xb5\x2f\xfd", "-cq" },
};

enum { FORMATS = sizeof formats / sizeof formats[0] };

static const struct format *format_of(const char *name)
{
    const size_t length = strlen(name);
    for (size_t i = 0; i < FORMATS; i++) {
        const size_t ending = strlen(formats[i].ending);
        if (length > ending && strcmp(name + length - ending, formats[i].ending) == 0)
            return &formats[i];
    }
    return NULL;
}

const char *packed_by(const char *name)
{
    const struct format *format = format_of(name);
    return format == NULL ? NULL : format->tool;
}

const char *packed_reason(const char *name, int error)
{
    const struct format *format = format_of(name);
    const bool is_gzip = format == &formats[0];
    if (error == IS_MCAP)
        return "it is an MCAP file; convert it to a recording with `frobc convert`";
    if (format == NULL)
        return error == OTHER_FORMAT
                   ? "it is compressed; rename it so that its name ends in .gz or .zst"
                   : strerror(error);
    switch (error) {
    case NOT_INSTALLED:
        return is_gzip ? "this needs the program gzip, which is not installed"
                       : "this needs the program zstd, which is not installed (`apt install zstd`)";
    case CUT_OFF:
        return "the archive is truncated or damaged (`frobc convert` recovers its complete rows)";
    case OTHER_FORMAT:
        return is_gzip ? "its name says that it is compressed by gzip, but it is not"
                       : "its name says that it is compressed by zstd, but it is not";
    case EPIPE: return is_gzip ? "gzip ended early" : "zstd ended early";
    default: return strerror(error);
    }
}

/* Checks whether the first bytes of the file match its name. Returns an error number, or 0 if they
 * match or cannot be examined because the file is a pipe. */
static int wrong_beginning(int file, const struct format *named)
{
    char head[4] = { 0 };
    if (pread(file, head, sizeof head, 0) < (ssize_t)sizeof head)
        return 0;
    if (memcmp(head, "\x89MCA", sizeof head) == 0)
        return IS_MCAP;
    for (size_t i = 0; i < FORMATS; i++)
        if (memcmp(head, formats[i].magic, strlen(formats[i].magic)) == 0)
            return named == &formats[i] ? 0 : OTHER_FORMAT;
    return named == NULL ? 0 : OTHER_FORMAT;
}

/* Waits for the process; returns whether it succeeded. */
static bool wait_for(pid_t process)
{
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
            return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* Starts the tool with these files as its input and output. Returns its process id, or 0 with errno
 * set. A process that compresses ignores signals from the terminal, and continues after the host
 * has ended, until it has written all data. */
static pid_t start(const struct format *format, bool packs, int from, int to)
{
    const pid_t host = getpid();
    char tool[8], options[8];
    char *arguments[] = { tool, options, NULL };
    sigset_t deaf_to;
    volatile int error = 0;
    pid_t process;
    snprintf(tool, sizeof tool, "%s", format->tool);
    snprintf(options, sizeof options, "%s", packs ? format->packing : "-dcq");
    sigemptyset(&deaf_to);
    if (packs) {
        sigaddset(&deaf_to, SIGINT);
        sigaddset(&deaf_to, SIGQUIT);
        sigaddset(&deaf_to, SIGTERM);
        sigaddset(&deaf_to, SIGHUP);
        sigaddset(&deaf_to, SIGTSTP);
    }
    /* vfork does not copy the host's memory, which may be large or locked; `error` is shared. */
    process = vfork();
    if (process == 0) {
        if (!packs)
            child_ends_with(host, SIGKILL);
        sigprocmask(SIG_SETMASK, &deaf_to, NULL);
        signal(SIGPIPE, SIG_DFL);
        dup2(from, STDIN_FILENO);
        dup2(to, STDOUT_FILENO);
        /* Only the tool can report write errors; the host reports read errors itself. */
        if (!packs)
            dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
        execvp(tool, arguments);
        error = errno;
        _exit(127);
    }
    if (process > 0 && error != 0)
        wait_for(process);
    if (process > 0)
        errno = error == ENOENT ? NOT_INSTALLED : error;
    return process > 0 && error == 0 ? process : 0;
}

static void close_quietly(int file)
{
    const int error = errno;
    close(file);
    errno = error;
}

/* ---- Writing */

/* Uses a pair of sockets instead of a pipe. Writing to a socket without a reader fails without
 * raising a signal, and a socket can be shut down even if another process has inherited it. */
static bool put_tool(struct packer *packer, const struct format *format, int file)
{
    int ends[2];
    packer->file = -1;
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return false;
    packer->process = start(format, true, ends[1], file);
    close_quietly(ends[1]);
    if (packer->process == 0)
        close_quietly(ends[0]);
    else
        packer->file = ends[0];
    return packer->process > 0;
}

/* Truncates the file. This must be the last step, so that the file's old contents are lost only if
 * all other steps succeeded. */
static bool make_empty(int file)
{
    struct stat status;
    return fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || ftruncate(file, 0) == 0;
}

bool packer_open(struct packer *packer, const char *name)
{
    const struct format *format = format_of(name);
    const int file = open(name, O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    memset(packer, 0, sizeof *packer);
    packer->file = file;
    if (file < 0)
        return false;
    if (format == NULL)
        return make_empty(file);
    if (put_tool(packer, format, file) && make_empty(file)) {
        close(file);
        return true;
    }
    close_quietly(file);
    packer->failed = true;
    return false;
}

bool packer_put(struct packer *packer, const char *bytes, size_t size)
{
    while (size > 0) {
        const ssize_t put = packer->process == 0 ? write(packer->file, bytes, size)
                                                 : send(packer->file, bytes, size, MSG_NOSIGNAL);
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0) {
            packer->failed = true;
            return false;
        }
        bytes += put;
        size -= (size_t)put;
    }
    return true;
}

bool packer_close(struct packer *packer)
{
    bool ok = true;
    if (packer->file < 0)
        return true;
    if (packer->process > 0)
        shutdown(packer->file, SHUT_WR);
    ok = close(packer->file) == 0;
    packer->file = -1;
    if (packer->process > 0 && !wait_for(packer->process)) {
        errno = EPIPE;
        ok = false;
    }
    return ok || packer->failed;
}

static ssize_t stream_put(void *cookie, const char *bytes, size_t size)
{
    return packer_put((struct packer *)cookie, bytes, size) ? (ssize_t)size : 0;
}

static int stream_close_packer(void *cookie)
{
    const bool ok = packer_close((struct packer *)cookie);
    const int error = errno;
    free(cookie);
    errno = error;
    return ok ? 0 : -1;
}

FILE *packed_write(const char *name)
{
    static const cookie_io_functions_t functions = { NULL, stream_put, NULL, stream_close_packer };
    struct packer *packer = (struct packer *)malloc(sizeof *packer);
    FILE *stream;
    if (packer == NULL)
        return NULL;
    if (!packer_open(packer, name)) {
        free(packer);
        return NULL;
    }
    stream = fopencookie(packer, "w", functions);
    if (stream == NULL)
        stream_close_packer(packer);
    return stream;
}

/* ---- Reading */

struct unpacker {
    int pipe;
    pid_t process; /* 0 once waitpid has collected it */
};

static ssize_t stream_get(void *cookie, char *bytes, size_t size)
{
    struct unpacker *unpacker = (struct unpacker *)cookie;
    ssize_t got;
    do
        got = read(unpacker->pipe, bytes, size);
    while (got < 0 && errno == EINTR);
    if (got == 0 && unpacker->process > 0) {
        const bool ok = wait_for(unpacker->process);
        unpacker->process = 0;
        if (!ok) {
            errno = CUT_OFF;
            return -1;
        }
    }
    return got;
}

/* Closes the pipe first, so that the process ends even if it still has output to write. */
static int stream_close_unpacker(void *cookie)
{
    struct unpacker *unpacker = (struct unpacker *)cookie;
    close(unpacker->pipe);
    if (unpacker->process > 0)
        wait_for(unpacker->process);
    free(unpacker);
    return 0;
}

static FILE *read_from(int file, const struct format *format)
{
    static const cookie_io_functions_t functions = { stream_get, NULL, NULL,
                                                     stream_close_unpacker };
    struct unpacker *unpacker = (struct unpacker *)malloc(sizeof *unpacker);
    FILE *stream = NULL;
    int ends[2];
    if (unpacker == NULL || pipe2(ends, O_CLOEXEC) != 0) {
        free(unpacker);
        return NULL;
    }
    unpacker->pipe = ends[0];
    unpacker->process = start(format, false, file, ends[1]);
    close_quietly(ends[1]);
    if (unpacker->process > 0)
        stream = fopencookie(unpacker, "r", functions);
    if (stream == NULL) {
        const int error = errno;
        stream_close_unpacker(unpacker);
        errno = error;
    }
    return stream;
}

FILE *packed_read(const char *name)
{
    const struct format *format = format_of(name);
    const int file = open(name, O_RDONLY | O_CLOEXEC);
    FILE *stream = NULL;
    int wrong;
    if (file < 0)
        return NULL;
    wrong = wrong_beginning(file, format);
    if (wrong == 0 && format == NULL)
        return fdopen(file, "rb");
    if (wrong == 0)
        stream = read_from(file, format);
    else
        errno = wrong;
    close_quietly(file);
    return stream;
}
