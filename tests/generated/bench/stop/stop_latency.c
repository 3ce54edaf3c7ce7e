/* stop_latency -- measures the time from killing the controller of a driving robot until the
 * robot receives a stop command.
 *
 *   stop_latency EXE COUNT LANES
 *
 * EXE is a program for a Pioneer, made by `frobc build`. Each of the LANES processes plays a
 * minimal robot on its own pseudo-terminal: it starts EXE on it, waits until it receives a
 * command to drive, kills the process that runs the program's steps, and measures the time until
 * the whole packet `VEL 0` has arrived. The lanes run in parallel, so the machine is loaded.
 *
 * The reference, measured in the same lanes, is the time that the operating system itself needs:
 * from killing a process until another process, which waits for the end of a socket shared with
 * it, wakes up.
 *
 * Prints one JSON object a line: median, 99th percentile and maximum, in ms. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static int64_t now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

/* ---- A minimal robot */

struct robot {
    int line;
    uint8_t bytes[512];
    size_t count;
    bool in_session;
    int64_t sip_ns;
};

static void send_body(const struct robot *r, const uint8_t *body, size_t length)
{
    uint8_t packet[64] = { 0xFA, 0xFB, (uint8_t)(length + 2) };
    unsigned sum = 0;
    size_t i;
    memcpy(packet + 3, body, length);
    for (i = 0; i + 1 < length; i += 2)
        sum += (unsigned)body[i] << 8 | body[i + 1];
    if (i < length)
        sum ^= body[i];
    packet[3 + length] = (uint8_t)(sum >> 8);
    packet[4 + length] = (uint8_t)sum;
    if (write(r->line, packet, length + 5) < 0)
        return;
}

static void send_sip(struct robot *r)
{
    static const uint8_t sip[25] = { 0x32 };
    r->sip_ns = now_ns() + 50000000;
    send_body(r, sip, sizeof sip);
}

/* The value of a command: a speed in mm/s, or NOTHING for other commands. */
enum { NOTHING = 1 << 20 };

static int obey(struct robot *r, const uint8_t *body, size_t length)
{
    static const uint8_t names[] = "\2bench\0Pioneer\0p3dx";
    if (!r->in_session && body[0] < 2 && length == 1)
        send_body(r, body, 1);
    if (!r->in_session && body[0] == 2) {
        send_body(r, names, sizeof names);
        r->in_session = true;
    }
    if (body[0] == 11 && length >= 4)
        return (body[2] | body[3] << 8) * (body[1] == 0x1B ? -1 : 1);
    return NOTHING;
}

/* Takes a packet that has arrived; returns NOTHING if it sets no speed. */
static int next(struct robot *r)
{
    while (r->count >= 3) {
        size_t whole = r->bytes[2] + 3u;
        if (r->bytes[0] != 0xFA || r->bytes[1] != 0xFB) {
            memmove(r->bytes, r->bytes + 1, --r->count);
        } else if (r->count < whole) {
            break;
        } else {
            int speed = obey(r, r->bytes + 3, whole - 5);
            r->count -= whole;
            memmove(r->bytes, r->bytes + whole, r->count);
            if (speed != NOTHING)
                return speed;
        }
    }
    return NOTHING;
}

/* Waits for a speed command: for a zero speed if `zero`, otherwise for a nonzero one. */
static bool wait_for(struct robot *r, bool zero, int64_t patience_ms)
{
    int64_t end = now_ns() + patience_ms * 1000000;
    while (now_ns() < end) {
        int speed = next(r);
        struct pollfd input = { r->line, POLLIN, 0 };
        ssize_t got;
        if (speed != NOTHING) {
            if ((speed == 0) == zero)
                return true;
            continue;
        }
        if (r->in_session && now_ns() >= r->sip_ns)
            send_sip(r);
        poll(&input, 1, 5);
        got = read(r->line, r->bytes + r->count, sizeof r->bytes - r->count);
        if (got > 0)
            r->count += (size_t)got;
    }
    return false;
}

/* ---- Kills */

/* Returns the first child of a process, which runs the program's steps. */
static pid_t first_child(pid_t parent)
{
    char path[64];
    long child = 0;
    FILE *file;
    snprintf(path, sizeof path, "/proc/%ld/task/%ld/children", (long)parent, (long)parent);
    file = fopen(path, "r");
    if (file == NULL)
        return 0;
    if (fscanf(file, "%ld", &child) != 1)
        child = 0;
    fclose(file);
    return (pid_t)child;
}

static int open_line(void)
{
    struct termios settings;
    int line = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (line < 0 || grantpt(line) != 0 || unlockpt(line) != 0)
        return -1;
    tcgetattr(line, &settings);
    cfmakeraw(&settings);
    tcsetattr(line, TCSANOW, &settings);
    return line;
}

/* Kills a controller once. Returns the time to the stop in ns, or -1. */
static int64_t kill_once(const char *exe)
{
    struct robot robot;
    pid_t pid, controller;
    int64_t started, took = -1;
    memset(&robot, 0, sizeof robot);
    robot.line = open_line();
    if (robot.line < 0)
        return -1;
    pid = fork();
    if (pid == 0) {
        int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, 1);
        dup2(nowhere, 2);
        execl(exe, exe, "--device", ptsname(robot.line), "--set", "switch-baud=0", "--for", "60",
              (char *)NULL);
        _exit(127);
    }
    if (wait_for(&robot, false, 10000) && (controller = first_child(pid)) != 0) {
        started = now_ns();
        kill(controller, SIGKILL);
        if (wait_for(&robot, true, 10000))
            took = now_ns() - started;
    }
    while (waitpid(pid, NULL, WNOHANG) == 0) {
        if (took < 0)
            kill(pid, SIGKILL);
        wait_for(&robot, true, 20);
    }
    close(robot.line);
    return took;
}

/* The time that the system needs to tell a process that another one was killed. */
static int64_t reference_once(void)
{
    int ends[2];
    int64_t started;
    pid_t pid;
    struct pollfd end;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return -1;
    pid = fork();
    if (pid == 0)
        for (;;)
            pause();
    close(ends[1]);
    end.fd = ends[0];
    end.events = POLLIN;
    poll(&end, 1, 5);
    started = now_ns();
    kill(pid, SIGKILL);
    poll(&end, 1, 1000);
    started = now_ns() - started;
    waitpid(pid, NULL, 0);
    close(ends[0]);
    return started;
}

/* ---- Figures */

static int by_size(const void *a, const void *b)
{
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x > y) - (x < y);
}

static void print(const char *measure, int64_t value, int64_t reference)
{
    printf("{\"program\": \"drive\", \"measure\": \"kill to stop, %s\", \"compiler\": \"\", "
           "\"value\": %.4f, \"reference\": %.4f, \"ratio\": %.2f, \"unit\": \"ms\"}\n",
           measure, (double)value * 1e-6, (double)reference * 1e-6,
           (double)value / (double)reference);
}

int main(int argc, char **argv)
{
    size_t count = argc > 3 ? (size_t)atoi(argv[2]) : 0,
           lanes = argc > 3 ? (size_t)atoi(argv[3]) : 0;
    int64_t *taken, *reference;
    size_t lost = 0;
    if (count == 0 || lanes == 0) {
        fprintf(stderr, "usage: stop_latency EXE COUNT LANES\n");
        return 2;
    }
    taken = (int64_t *)mmap(NULL, 2 * count * sizeof *taken, PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (taken == MAP_FAILED)
        return 2;
    reference = taken + count;
    for (size_t lane = 0; lane < lanes; lane++) {
        if (fork() == 0) {
            for (size_t i = lane; i < count; i += lanes) {
                taken[i] = kill_once(argv[1]);
                reference[i] = reference_once();
            }
            _exit(0);
        }
    }
    while (wait(NULL) > 0 || errno == EINTR)
        continue;
    qsort(taken, count, sizeof *taken, by_size);
    qsort(reference, count, sizeof *reference, by_size);
    while (lost < count && taken[lost] < 0)
        lost++;
    if (lost > 0) {
        fprintf(stderr, "error: after %zu of %zu kills no stop came\n", lost, count);
        return 1;
    }
    print("median", taken[count / 2], reference[count / 2]);
    print("99th percentile", taken[count * 99 / 100], reference[count * 99 / 100]);
    print("maximum", taken[count - 1], reference[count - 1]);
    return 0;
}
