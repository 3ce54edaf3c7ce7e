#include "hal/posix/serial.h"

#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "hal/posix/clock.h"
#include "hal/posix/parts.h"

#define DRAIN_PATIENCE_NS INT64_C(200000000)

/* Explains which group may open the device, and how to join it. */
static void explain_denied(const char *device, char *message, size_t room)
{
    struct stat status;
    const struct group *group = NULL;
    if (stat(device, &status) == 0)
        group = getgrgid(status.st_gid);
    snprintf(message, room,
             "cannot open %s: permission denied; join its group with `sudo adduser $USER %s`, then "
             "log out and in again",
             device,
             group != NULL && strcmp(group->gr_name, "root") != 0 ? group->gr_name : "dialout");
}

static enum frob_status explain_busy(const char *device, char *message, size_t room)
{
    char holder[128];
    if (frob_posix_holder(device, holder, sizeof holder))
        snprintf(message, room, "%s is in use by %s; end that program first", device, holder);
    else
        snprintf(message, room, "%s is in use by another program; end that program first", device);
    return FROB_IN_USE;
}

static enum frob_status explain(int error, const char *device, char *message, size_t room)
{
    switch (error) {
    case ENOENT:
    case ENOTDIR:
        snprintf(message, room,
                 "there is no device %s; plug it in (/dev/serial/by-id lists the devices that are "
                 "plugged in)",
                 device);
        return FROB_NOT_FOUND;
    case ENXIO:
    case ENODEV:
    case EIO:
        snprintf(message, room, "no device answers at %s: %s", device, strerror(error));
        return FROB_NOT_FOUND;
    case EACCES:
    case EPERM: explain_denied(device, message, room); return FROB_DENIED;
    case EBUSY:
    case EWOULDBLOCK: return explain_busy(device, message, room);
    case ENOTTY:
        snprintf(message, room, "%s is not a serial line", device);
        return FROB_UNSUPPORTED;
    default:
        snprintf(message, room, "cannot open %s: %s", device, strerror(error));
        return FROB_LOST;
    }
}

/* Sets 8N1 without flow control or translation, and ignores the modem lines. */
static int make_raw(int fd)
{
    struct termios settings;
    if (tcgetattr(fd, &settings) != 0)
        return -1;
    settings.c_iflag &= (tcflag_t) ~(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL |
                                     IXON | IXOFF | IXANY | INPCK);
    settings.c_oflag &= (tcflag_t)~OPOST;
    settings.c_lflag &= (tcflag_t) ~(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
    settings.c_cflag &= (tcflag_t) ~(CSIZE | PARENB | CSTOPB | CRTSCTS | HUPCL);
    settings.c_cflag |= CS8 | CREAD | CLOCAL;
    /* With O_NONBLOCK, read() fails with EAGAIN if there are no bytes, and returns 0 only if the
     * line is gone. */
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    return tcsetattr(fd, TCSANOW, &settings);
}

static int open_terminal(int *fd, const char *device, uint32_t bits_per_s)
{
    int error = 0;
    *fd = open(device, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (*fd < 0)
        return errno;
    if (!isatty(*fd))
        error = ENOTTY;
    else if (flock(*fd, LOCK_EX | LOCK_NB) != 0 || make_raw(*fd) != 0)
        error = errno;
    if (error != 0) {
        close(*fd);
        *fd = -1;
        return error;
    }
    /* Also keeps out programs that do not lock the device. */
    ioctl(*fd, TIOCEXCL);
    if (frob_posix_set_terminal_rate(*fd, bits_per_s) != 0) {
        error = errno;
        close(*fd);
        *fd = -1;
        return error;
    }
    tcflush(*fd, TCIOFLUSH);
    return 0;
}

enum frob_status frob_posix_open(struct frob_posix_line *line, const char *device,
                                 uint32_t bits_per_s, char *message, size_t room)
{
    int error;
    memset(line, 0, sizeof *line);
    line->fd = -1;
    if (frob_posix_is_tcp(device))
        return frob_posix_connect(line, device, message, room);
    error = open_terminal(&line->fd, device, bits_per_s);
    line->is_terminal = true;
    return error == 0 ? FROB_OK : explain(error, device, message, room);
}

void frob_posix_adopt(struct frob_posix_line *line, int socket)
{
    const int flags = fcntl(socket, F_GETFL);
    memset(line, 0, sizeof *line);
    line->fd = socket;
    fcntl(socket, F_SETFL, flags | O_NONBLOCK);
}

enum frob_status frob_posix_reopen(struct frob_posix_line *line, const char *device,
                                   uint32_t bits_per_s)
{
    int error;
    line->fd = -1;
    line->lost = false;
    if (line->is_terminal)
        error = open_terminal(&line->fd, device, bits_per_s);
    else
        error = frob_posix_connect_again(line);
    return error == 0 ? FROB_OK : FROB_NOT_FOUND;
}

static enum frob_status lost(struct frob_posix_line *line)
{
    line->lost = true;
    return FROB_LOST;
}

static enum frob_status line_read(void *port, uint8_t *bytes, size_t room, size_t *count)
{
    struct frob_posix_line *line = (struct frob_posix_line *)port;
    ssize_t got;
    *count = 0;
    if (line->lost)
        return FROB_LOST;
    do
        got = read(line->fd, bytes, room);
    while (got < 0 && errno == EINTR);
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
        return FROB_OK;
    if (got <= 0)
        return lost(line);
    *count = (size_t)got;
    line->heard = true;
    return FROB_OK;
}

static struct timespec until(int64_t left_ns)
{
    struct timespec result;
    if (left_ns < 0)
        left_ns = 0;
    result.tv_sec = (time_t)(left_ns / 1000000000);
    result.tv_nsec = (long)(left_ns % 1000000000);
    return result;
}

/* Waits until the line is ready for `events`. Returns 1 if it is ready, 0 after a timeout or a
 * signal, and -1 if the line is gone. */
static int ready(struct frob_posix_line *line, short events, int64_t until_ns)
{
    struct pollfd wait = { line->fd, events, 0 };
    struct timespec left = until(until_ns - frob_now_ns(&frob_posix_clock));
    int n = ppoll(&wait, 1, &left, NULL);
    if (n < 0)
        return errno == EINTR ? 0 : -1;
    if (n == 0)
        return 0;
    /* Bytes that arrived before a hang-up can still be read. */
    if ((wait.revents & events) != 0)
        return 1;
    return -1;
}

static enum frob_status line_write(void *port, const uint8_t *bytes, size_t count)
{
    struct frob_posix_line *line = (struct frob_posix_line *)port;
    int64_t until_ns = frob_now_ns(&frob_posix_clock) + FROB_WRITE_PATIENCE_NS;
    if (line->lost)
        return FROB_LOST;
    while (count > 0) {
        ssize_t put = line->is_terminal ? write(line->fd, bytes, count)
                                        : frob_posix_send(line->fd, bytes, count);
        if (put > 0) {
            bytes += put;
            count -= (size_t)put;
        } else if (put < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
            return lost(line);
        } else if (frob_now_ns(&frob_posix_clock) >= until_ns) {
            return FROB_TIMEOUT;
        } else if (ready(line, POLLOUT, until_ns) < 0) {
            return lost(line);
        }
    }
    return FROB_OK;
}

static enum frob_status line_wait(void *port, int64_t until_ns)
{
    struct frob_posix_line *line = (struct frob_posix_line *)port;
    int n;
    if (line->lost)
        return FROB_LOST;
    n = ready(line, POLLIN, until_ns);
    if (n < 0)
        return lost(line);
    return n > 0 ? FROB_OK : FROB_TIMEOUT;
}

static enum frob_status line_set_rate(void *port, uint32_t bits_per_s)
{
    struct frob_posix_line *line = (struct frob_posix_line *)port;
    if (line->lost)
        return FROB_LOST;
    if (!line->is_terminal)
        return FROB_UNSUPPORTED;
    if (frob_posix_set_terminal_rate(line->fd, bits_per_s) == 0)
        return FROB_OK;
    return errno == EINVAL ? FROB_UNSUPPORTED : lost(line);
}

static enum frob_status line_discard(void *port)
{
    struct frob_posix_line *line = (struct frob_posix_line *)port;
    uint8_t bytes[256];
    size_t count;
    enum frob_status status;
    do
        status = line_read(port, bytes, sizeof bytes, &count);
    while (status == FROB_OK && count > 0);
    return line->lost ? FROB_LOST : status;
}

static const struct frob_serial_operations operations = { line_read, line_write, line_wait,
                                                          line_set_rate, line_discard };

struct frob_serial frob_posix_serial(struct frob_posix_line *line)
{
    struct frob_serial result = { &operations, line };
    return result;
}

/* Waits, up to a limit, until the written bytes have been transmitted. If the line accepts no
 * bytes, the kernel would otherwise wait for half a minute. */
static void drain(const struct frob_posix_line *line)
{
    int64_t end_ns = frob_now_ns(&frob_posix_clock) + DRAIN_PATIENCE_NS;
    int waiting = 0;
    while (ioctl(line->fd, TIOCOUTQ, &waiting) == 0 && waiting > 0 &&
           frob_now_ns(&frob_posix_clock) < end_ns) {
        struct timespec pause = { 0, 1000000 };
        nanosleep(&pause, NULL);
    }
    if (waiting > 0)
        tcflush(line->fd, TCOFLUSH);
}

void frob_posix_close(struct frob_posix_line *line)
{
    if (line->fd < 0)
        return;
    if (line->is_terminal && !line->lost)
        drain(line);
    close(line->fd);
    line->fd = -1;
}
