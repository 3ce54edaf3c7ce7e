/* Tests the POSIX line with faulty system calls, drawn from seeds: EINTR, EAGAIN, short reads
 * and writes, a line that accepts no data, EIO, hang-ups.
 *
 * The linker replaces the system calls with the functions below (--wrap), which use bytes in
 * memory and virtual time, so the test never waits and needs no device. */
#include "check.h"
#include "random.h"

#include "hal/posix/clock.h"
#include "hal/posix/serial.h"

#include <errno.h>
#include <poll.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { ROOM = 65536, FD = 1000 };

static struct {
    uint64_t seed;
    int64_t now_ns;
    /* number of calls, of 256, that fail with EINTR or EAGAIN */
    unsigned interrupted, refused;
    bool blocked;                       /* writes are never accepted */
    enum { ALIVE, BROKEN, ENDED } life; /* then EIO, or end of file */
    uint8_t in[ROOM], out[ROOM];
    size_t in_count, in_taken, out_count;
} os;

static bool falls(unsigned of_256)
{
    return random_below(&os.seed, 256) < of_256;
}

/* A random part of the count, at least 1. */
static size_t part(size_t count)
{
    return falls(128) ? count : 1 + random_below(&os.seed, (unsigned)count);
}

/* Fails with EINTR or EAGAIN sometimes, and with EIO when the line is broken. */
static bool fails(void)
{
    os.now_ns += 1000;
    errno = os.life == BROKEN       ? EIO
            : falls(os.interrupted) ? EINTR
            : falls(os.refused)     ? EAGAIN
                                    : 0;
    return errno != 0;
}

ssize_t __wrap_read(int fd, void *bytes, size_t room);
ssize_t __wrap_write(int fd, const void *bytes, size_t count);
int __wrap_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *patience, const void *mask);
int __wrap_clock_gettime(clockid_t clock, struct timespec *time);

ssize_t __wrap_read(int fd, void *bytes, size_t room)
{
    size_t count = os.in_count - os.in_taken;
    if (fd != FD || fails())
        return -1;
    if (count == 0) {
        errno = EAGAIN;
        return os.life == ENDED ? 0 : -1;
    }
    count = part(count < room ? count : room);
    memcpy(bytes, os.in + os.in_taken, count);
    os.in_taken += count;
    return (ssize_t)count;
}

ssize_t __wrap_write(int fd, const void *bytes, size_t count)
{
    if (fd != FD || fails())
        return -1;
    if (os.blocked || os.out_count + count > ROOM) {
        errno = EAGAIN;
        return -1;
    }
    count = part(count);
    memcpy(os.out + os.out_count, bytes, count);
    os.out_count += count;
    return (ssize_t)count;
}

int __wrap_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *patience, const void *mask)
{
    int64_t left_ns = (int64_t)patience->tv_sec * 1000000000 + patience->tv_nsec;
    (void)mask;
    if (n != 1 || fds->fd != FD)
        return -1;
    os.now_ns += 1000;
    fds->revents = 0;
    if (falls(os.interrupted)) {
        errno = EINTR;
        return -1;
    }
    if (os.life != ALIVE)
        fds->revents = POLLHUP;
    if ((fds->events & POLLIN) != 0 && os.in_taken < os.in_count)
        fds->revents |= POLLIN;
    if ((fds->events & POLLOUT) != 0 && !os.blocked && os.life == ALIVE)
        fds->revents |= POLLOUT;
    if (fds->revents == 0)
        os.now_ns += left_ns;
    return fds->revents != 0;
}

int __wrap_clock_gettime(clockid_t clock, struct timespec *time)
{
    (void)clock;
    time->tv_sec = (time_t)(os.now_ns / 1000000000);
    time->tv_nsec = (long)(os.now_ns % 1000000000);
    return 0;
}

static struct frob_posix_line line;
static struct frob_serial serial;

static void start(uint64_t seed)
{
    memset(&os, 0, sizeof os);
    os.seed = seed;
    os.now_ns = 1000000000;
    os.interrupted = random_below(&os.seed, 200);
    os.refused = random_below(&os.seed, 100);
    memset(&line, 0, sizeof line);
    line.fd = FD;
    line.is_terminal = true;
    serial = frob_posix_serial(&line);
}

/* All bytes of a seed must arrive once and in order. */
static bool reads_all(void)
{
    uint8_t got[ROOM], some[300];
    size_t taken = 0, count;
    for (size_t i = 0; i < 5000; i++)
        os.in[i] = (uint8_t)random_below(&os.seed, 256);
    while (taken < 5000) {
        if (falls(64) && os.in_count < 5000)
            os.in_count += 1 + random_below(&os.seed, (unsigned)(5000 - os.in_count));
        if (serial.operations->wait(serial.port, os.now_ns + 1000000) == FROB_LOST ||
            serial.operations->read(serial.port, some, 1 + random_below(&os.seed, 300), &count) !=
                FROB_OK)
            return false;
        memcpy(got + taken, some, count);
        taken += count;
    }
    return taken == 5000 && memcmp(got, os.in, taken) == 0;
}

static bool writes_all(void)
{
    uint8_t sent[ROOM];
    size_t count = 0;
    for (int i = 0; i < 100; i++) {
        size_t size = 1 + random_below(&os.seed, 100);
        for (size_t k = 0; k < size; k++)
            sent[count + k] = (uint8_t)random_below(&os.seed, 256);
        if (serial.operations->write(serial.port, sent + count, size) != FROB_OK)
            return false;
        count += size;
    }
    return count == os.out_count && memcmp(sent, os.out, count) == 0;
}

/* A write to a line that accepts no data must time out. */
static bool gives_up_writing(void)
{
    int64_t began_ns = os.now_ns;
    os.blocked = true;
    if (serial.operations->write(serial.port, (const uint8_t *)"abc", 3) != FROB_TIMEOUT)
        return false;
    if (os.out_count != 0 || os.now_ns - began_ns < FROB_WRITE_PATIENCE_NS ||
        os.now_ns - began_ns > FROB_WRITE_PATIENCE_NS + 1000000)
        return false;
    os.blocked = false;
    return serial.operations->write(serial.port, (const uint8_t *)"abc", 3) == FROB_OK &&
           os.out_count == 3;
}

/* After EIO or the end of file every call must report a lost line; data from before a hang-up
 * must be read first. */
static bool is_lost(int life)
{
    uint8_t bytes[8];
    size_t count, taken = 0;
    enum frob_status status = FROB_OK;
    os.in_count = 5;
    os.life = life == ENDED ? ENDED : ALIVE;
    for (int i = 0; i < 2000 && status == FROB_OK && taken < 5; i++) {
        status = serial.operations->read(serial.port, bytes, 1, &count);
        taken += count;
    }
    if (status != FROB_OK || taken != 5)
        return false;
    os.life = life == ENDED ? ENDED : BROKEN;
    os.refused = 0;
    if (serial.operations->read(serial.port, bytes, sizeof bytes, &count) != FROB_LOST ||
        count != 0)
        return false;
    os.life = ALIVE; /* a new device now */
    return serial.operations->read(serial.port, bytes, sizeof bytes, &count) == FROB_LOST &&
           serial.operations->write(serial.port, bytes, 1) == FROB_LOST &&
           serial.operations->wait(serial.port, os.now_ns + 1000000) == FROB_LOST &&
           serial.operations->discard(serial.port) == FROB_LOST &&
           serial.operations->set_rate(serial.port, 9600) == FROB_LOST && os.out_count == 0;
}

static bool wait_sees_the_end(void)
{
    enum frob_status status = FROB_TIMEOUT;
    os.life = ENDED;
    for (int i = 0; i < 2000 && status == FROB_TIMEOUT; i++)
        status = serial.operations->wait(serial.port, os.now_ns + 1000000);
    return status == FROB_LOST;
}

static bool discards(void)
{
    uint8_t bytes[8];
    size_t count = 1;
    os.in_count = 3000;
    os.refused = 0; /* a spurious EAGAIN may rightly end the write early */
    return serial.operations->discard(serial.port) == FROB_OK &&
           serial.operations->read(serial.port, bytes, sizeof bytes, &count) == FROB_OK &&
           count == 0;
}

static bool write_finds_it_broken(void)
{
    os.life = BROKEN;
    return serial.operations->write(serial.port, (const uint8_t *)"abc", 3) == FROB_LOST &&
           serial.operations->write(serial.port, (const uint8_t *)"abc", 3) == FROB_LOST;
}

enum { SEEDS = 200 };

int main(void)
{
    unsigned read_all = 0, wrote_all = 0, gave_up = 0, broken = 0, ended = 0, seen = 0, emptied = 0,
             found = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        start(seed);
        read_all += reads_all();
        start(seed);
        wrote_all += writes_all();
        start(seed);
        gave_up += gives_up_writing();
        start(seed);
        broken += is_lost(BROKEN);
        start(seed);
        ended += is_lost(ENDED);
        start(seed);
        seen += wait_sees_the_end();
        start(seed);
        emptied += discards();
        start(seed);
        found += write_finds_it_broken();
    }
    check(read_all == SEEDS, "EINTR, EAGAIN and short reads lose no byte");
    check(wrote_all == SEEDS, "EINTR, EAGAIN and short writes lose no byte");
    check(gave_up == SEEDS, "a write to a line that takes nothing ends in its time");
    check(broken == SEEDS, "EIO loses the line, to every later call too");
    check(ended == SEEDS, "a hang-up is noticed behind the last bytes");
    check(seen == SEEDS, "waiting notices a hang-up");
    check(emptied == SEEDS, "discarding takes all that is there");
    check(found == SEEDS, "a write notices EIO");
    return check_status();
}
