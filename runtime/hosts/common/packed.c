#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* fopencookie */
#endif

#include "packed.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* Faults that are none of the system's, as an errno. */
enum { NOT_INSTALLED = ENOPKG, CUT_OFF = EBADMSG, OTHER_FORMAT = EILSEQ, IS_MCAP = EPROTO };

static const struct format {
    const char *tool, *ending;
    const char *magic;   /* its first bytes */
    const char *packing; /* its options; gzip would note the time */
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
        return "it is MCAP, of which `frobc convert` makes a recording";
    if (format == NULL)
        return error == OTHER_FORMAT
                   ? "it is compressed; give it a name that says how, with .gz or .zst at its end"
                   : strerror(error);
    switch (error) {
    case NOT_INSTALLED:
        return is_gzip
                   ? "the program gzip, by which it goes, is not installed"
                   : "the program zstd, by which it goes, is not installed (`apt install zstd`)";
    case CUT_OFF: return "the archive is cut off or damaged (`frobc convert` keeps its whole rows)";
    case OTHER_FORMAT:
        return is_gzip ? "it is not compressed by gzip, as its name says"
                       : "it is not compressed by zstd, as its name says";
    case EPIPE:
        return is_gzip ? "gzip has ended before its time" : "zstd has ended before its time";
    default: return strerror(error);
    }
}

/* What is wrong with the file's beginning, by what its name says; 0: nothing, and of one that
 * cannot be looked at, being a pipe. */
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

/* Starts the tool between two files; its process, or 0 with errno set. */
static pid_t start(const struct format *format, bool packs, int from, int to)
{
    char tool[8], options[8];
    char *arguments[] = { tool, options, NULL };
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t deaf_to, as_usual;
    pid_t process = 0;
    int error;
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
    sigemptyset(&as_usual);
    sigaddset(&as_usual, SIGPIPE);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &deaf_to);
    posix_spawnattr_setsigdefault(&attributes, &as_usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, from, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, to, STDOUT_FILENO);
    /* Why it cannot write, only it knows; what it reads is known here. */
    if (!packs)
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    error = posix_spawnp(&process, tool, &actions, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    errno = error == ENOENT ? NOT_INSTALLED : error;
    return error == 0 ? process : 0;
}

/* Whether it has done all that it was to. */
static bool wait_for(pid_t process)
{
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
            return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static void close_quietly(int file)
{
    const int error = errno;
    close(file);
    errno = error;
}

/* {1 Writing} */

/* A pair of sockets and not a pipe: one that nobody reads any more is an error and no signal,
 * and its end can be told even if a process that was forked meanwhile holds it too. */
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

/* What is there is lost when all else is ready, and not before. */
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

/* {1 Reading} */

struct unpacker {
    int pipe;
    pid_t process; /* 0: it has been waited for */
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

/* It may have more to say than anybody wants to hear. */
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
