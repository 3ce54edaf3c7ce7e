#include "hal/template/template.h"

/* The variables that a port's interrupt handlers share with its functions, such as a ring buffer of
 * received bytes and the upper half of the timer. */
static struct {
    int64_t now_ns;
    uint32_t rate;
} board;

void frob_template_clock_start(void)
{
    board.now_ns = 0;
}

/* Read the free-running timer. A 32-bit timer wraps around: count its overflows in its interrupt,
 * and read both halves until they agree. */
static int64_t now_ns(void *port)
{
    (void)port;
    return board.now_ns;
}

/* Wait for interrupts until the time is reached. Here time passes immediately. */
static void sleep_until(void *port, int64_t until_ns)
{
    (void)port;
    if (until_ns > board.now_ns)
        board.now_ns = until_ns;
}

enum frob_status frob_template_serial_open(uint32_t bits_per_s)
{
    board.rate = bits_per_s;
    return FROB_OK;
}

/* Take bytes out of the ring that the receive interrupt fills. */
static enum frob_status line_read(void *port, uint8_t *bytes, size_t room, size_t *count)
{
    (void)port;
    (void)bytes;
    (void)room;
    *count = 0;
    return FROB_OK;
}

/* Put bytes into the transmitter, waiting for room. */
static enum frob_status line_write(void *port, const uint8_t *bytes, size_t count)
{
    (void)port;
    (void)bytes;
    (void)count;
    return FROB_OK;
}

/* Sleep until the ring has bytes or the time is reached. */
static enum frob_status line_wait(void *port, int64_t until_ns)
{
    sleep_until(port, until_ns);
    return FROB_TIMEOUT;
}

/* Wait until the transmitter is empty, then change its divisor. */
static enum frob_status line_set_rate(void *port, uint32_t bits_per_s)
{
    (void)port;
    board.rate = bits_per_s;
    return FROB_OK;
}

/* Empty the ring. */
static enum frob_status line_discard(void *port)
{
    (void)port;
    return FROB_OK;
}

static const struct frob_clock_operations clock_operations = { now_ns, sleep_until };
static const struct frob_serial_operations line_operations = { line_read, line_write, line_wait,
                                                               line_set_rate, line_discard };

const struct frob_clock frob_template_clock = { &clock_operations, 0 };
const struct frob_serial frob_template_serial = { &line_operations, 0 };

void frob_template_say(const char *text)
{
    (void)text;
}
