/* rover_board.c -- a Rover's onboard computer, for `frobc serve` and for tests.
 *
 * This code was written from the command table in README.md, independently of the driver. Commands
 * are lines that end with a carriage return. The answer to `p` is sent when the echo would have
 * come back; commands that arrive in the meantime have to wait. If no `m` command arrives within
 * the time set with `w` (initially two seconds), the wheels stop. */
#include <frob/board.h>

#include "rover.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COUNTS_PER_M 8000.0
#define SEPARATION_M 0.19
#define LOOPS_PER_S 30.0
#define PING_NS INT64_C(20000000)
#define ROUND_NS INT64_C(150000000) /* older echoes belong to an earlier round */
#define FULL_V 15.0

enum { RANGERS = 5, LONGEST = 30, WAITING = 128 };

struct board {
    bool on;
    int64_t now_ns;
    double left_m, right_m; /* distances that the wheels have travelled */
    double heading_rad;     /* the body's heading when `sense` was last called, */
    double x_m, y_m;        /* and its position */
    double battery_v;
    double echo_m[RANGERS];
    int64_t echo_ns[RANGERS];
    int32_t left, right;           /* speeds of the wheels, in counts per 1/30 s */
    int64_t moved_ns, watchdog_ns; /* time of the last speed command, and its timeout */
    bool pings;
    int pinged;
    int64_t ping_ns;       /* time at which the pending ping is answered */
    char waiting[WAITING]; /* bytes that have not been processed yet */
    size_t waiting_count;
    char line[LONGEST + 1];
    size_t length;
    bool too_long;
};

static void say(struct frob_answer *answer, const char *text)
{
    for (; *text != '\0' && answer->count < sizeof answer->bytes; text++)
        answer->bytes[answer->count++] = (uint8_t)*text;
}

/* Updates the encoder distances from the body's motion, and stores the other readings. */
static void sense(void *memory, const void *from, int64_t now_ns)
{
    struct board *b = (struct board *)memory;
    const struct frob_rover_input *input = (const struct frob_rover_input *)from;
    const struct frob_pose *pose = &input->odometry;
    if (!b->on) {
        b->on = true;
        b->watchdog_ns = INT64_C(2000000000);
    } else {
        double turn = remainder(pose->heading - b->heading_rad, 2.0 * 3.14159265358979323846);
        double halfway = b->heading_rad + 0.5 * turn;
        double way =
            (pose->position.x - b->x_m) * cos(halfway) + (pose->position.y - b->y_m) * sin(halfway);
        b->left_m += way - 0.5 * turn * SEPARATION_M;
        b->right_m += way + 0.5 * turn * SEPARATION_M;
    }
    b->heading_rad = pose->heading;
    b->x_m = pose->position.x;
    b->y_m = pose->position.y;
    b->battery_v = input->battery;
    for (int i = 0; i < RANGERS; i++) {
        if (input->sonar[i].tag == FROB_EVENT_FLOAT_EVENT) {
            b->echo_m[i] = input->sonar[i].f0;
            b->echo_ns[i] = now_ns;
        }
    }
    b->now_ns = now_ns;
}

static void do_command(struct board *b, struct frob_answer *answer)
{
    char text[64];
    long first = 0, second = 0;
    char end = '\0';
    const char *line = b->line;
    switch (line[0]) {
    case '\0': return;
    case 'b':
        if (line[1] != '\0')
            break;
        say(answer, "57600\r\n");
        return;
    case 'e':
        if (line[1] != '\0')
            break;
        snprintf(text, sizeof text, "%ld %ld\r\n", lround(b->left_m * COUNTS_PER_M),
                 lround(b->right_m * COUNTS_PER_M));
        say(answer, text);
        return;
    case 'm':
        if (sscanf(line, "m %6ld %6ld%c", &first, &second, &end) != 2)
            break;
        b->left = (int32_t)first;
        b->right = (int32_t)second;
        b->moved_ns = b->now_ns;
        say(answer, "OK\r\n");
        return;
    case 'p':
        if (sscanf(line, "p %2ld%c", &first, &end) != 1 || first < 0 || first >= RANGERS)
            break;
        b->pings = true;
        b->pinged = (int)first;
        b->ping_ns = b->now_ns + PING_NS;
        return;
    case 'a':
        if (strcmp(line, "a 0") != 0)
            break;
        snprintf(text, sizeof text, "%ld\r\n", lround(fmin(b->battery_v / FULL_V, 1.0) * 1023.0));
        say(answer, text);
        return;
    case 'w':
        if (sscanf(line, "w %5ld%c", &first, &end) != 1 || first < 1)
            break;
        b->watchdog_ns = first * INT64_C(1000000);
        say(answer, "OK\r\n");
        return;
    default: break;
    }
    say(answer, "Invalid Command\r\n");
}

static void take(struct board *b, char byte, struct frob_answer *answer)
{
    if (byte != '\r') {
        if (b->length < LONGEST)
            b->line[b->length++] = byte;
        else
            b->too_long = true;
        return;
    }
    b->line[b->length] = '\0';
    if (b->too_long)
        say(answer, "Invalid Command\r\n");
    else
        do_command(b, answer);
    b->length = 0;
    b->too_long = false;
}

static void take_waiting(struct board *b, struct frob_answer *answer)
{
    size_t taken = 0;
    while (taken < b->waiting_count && !b->pings)
        take(b, b->waiting[taken++], answer);
    memmove(b->waiting, b->waiting + taken, b->waiting_count - taken);
    b->waiting_count -= taken;
}

static void receive(void *memory, uint8_t byte, struct frob_answer *answer)
{
    struct board *b = (struct board *)memory;
    if (b->waiting_count < WAITING) /* otherwise the byte is lost, as on a real board */
        b->waiting[b->waiting_count++] = (char)byte;
    take_waiting(b, answer);
}

static void advance(void *memory, int64_t now_ns, struct frob_answer *answer)
{
    struct board *b = (struct board *)memory;
    b->now_ns = now_ns;
    if (b->pings && now_ns >= b->ping_ns) {
        char text[24];
        bool heard = b->echo_m[b->pinged] > 0.0 && now_ns - b->echo_ns[b->pinged] <= ROUND_NS;
        snprintf(text, sizeof text, "%ld\r\n", heard ? lround(b->echo_m[b->pinged] * 100.0) : 0L);
        say(answer, text);
        b->pings = false;
    }
    if (now_ns - b->moved_ns >= b->watchdog_ns)
        b->left = b->right = 0;
    take_waiting(b, answer);
}

static void drive(const void *memory, void *into)
{
    const struct board *b = (const struct board *)memory;
    struct frob_rover_output *output = (struct frob_rover_output *)into;
    double left = b->left * LOOPS_PER_S / COUNTS_PER_M,
           right = b->right * LOOPS_PER_S / COUNTS_PER_M;
    output->forward = 0.5 * (left + right);
    output->turn = (right - left) / SEPARATION_M;
}

/* In C++, a const table has internal linkage without this declaration. */
extern const struct frob_board frob_rover_board;

const struct frob_board frob_rover_board = { "rover", 57600, sizeof(struct board), sense, receive,
                                             advance, drive };
