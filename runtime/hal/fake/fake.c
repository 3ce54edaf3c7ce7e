#include "hal/fake/fake.h"

#include <string.h>

static int64_t now_ns(void *port)
{
    return ((struct frob_fake_clock *)port)->now_ns;
}

static void sleep_until(void *port, int64_t until_ns)
{
    struct frob_fake_clock *clock = (struct frob_fake_clock *)port;
    if (until_ns > clock->now_ns)
        clock->now_ns = until_ns;
}

static const struct frob_clock_operations clock_operations = { now_ns, sleep_until };

struct frob_clock frob_fake_time(struct frob_fake_clock *clock)
{
    struct frob_clock result = { &clock_operations, clock };
    return result;
}

static bool put(struct frob_fake_queue *queue, uint8_t byte, int64_t arrive_ns)
{
    size_t last;
    if (queue->count == FROB_FAKE_ROOM)
        return false;
    last = (queue->first + queue->count) % FROB_FAKE_ROOM;
    queue->bytes[last] = byte;
    queue->arrive_ns[last] = arrive_ns;
    queue->count++;
    return true;
}

/* Removes at most `room` of the bytes that have arrived by `now`, and returns their number. */
static size_t take(struct frob_fake_queue *queue, uint8_t *bytes, size_t room, int64_t now)
{
    size_t taken = 0;
    while (taken < room && queue->count > 0 && queue->arrive_ns[queue->first] <= now) {
        bytes[taken++] = queue->bytes[queue->first];
        queue->first = (queue->first + 1) % FROB_FAKE_ROOM;
        queue->count--;
    }
    return taken;
}

static enum frob_status line_read(void *port, uint8_t *bytes, size_t room, size_t *count)
{
    struct frob_fake_line *line = (struct frob_fake_line *)port;
    *count = 0;
    if (line->lost)
        return FROB_LOST;
    *count = take(&line->to_driver, bytes, room, line->clock->now_ns);
    return FROB_OK;
}

static enum frob_status line_write(void *port, const uint8_t *bytes, size_t count)
{
    struct frob_fake_line *line = (struct frob_fake_line *)port;
    if (line->lost)
        return FROB_LOST;
    if (line->blocked) {
        line->clock->now_ns += FROB_WRITE_PATIENCE_NS;
        return FROB_TIMEOUT;
    }
    for (size_t i = 0; i < count; i++)
        if (!put(&line->from_driver, bytes[i], line->clock->now_ns))
            return FROB_TIMEOUT;
    return FROB_OK;
}

static enum frob_status line_wait(void *port, int64_t until_ns)
{
    struct frob_fake_line *line = (struct frob_fake_line *)port;
    const struct frob_fake_queue *queue = &line->to_driver;
    if (line->lost)
        return FROB_LOST;
    if (queue->count > 0 && queue->arrive_ns[queue->first] <= until_ns) {
        sleep_until(line->clock, queue->arrive_ns[queue->first]);
        return FROB_OK;
    }
    sleep_until(line->clock, until_ns);
    return FROB_TIMEOUT;
}

static enum frob_status line_set_rate(void *port, uint32_t bits_per_s)
{
    struct frob_fake_line *line = (struct frob_fake_line *)port;
    if (line->lost)
        return FROB_LOST;
    if (line->refuses_rates || (line->fastest != 0 && bits_per_s > line->fastest))
        return FROB_UNSUPPORTED;
    line->rate = bits_per_s;
    return FROB_OK;
}

static enum frob_status line_discard(void *port)
{
    struct frob_fake_line *line = (struct frob_fake_line *)port;
    uint8_t bytes[64];
    if (line->lost)
        return FROB_LOST;
    while (take(&line->to_driver, bytes, sizeof bytes, line->clock->now_ns) > 0)
        continue;
    return FROB_OK;
}

static const struct frob_serial_operations line_operations = { line_read, line_write, line_wait,
                                                               line_set_rate, line_discard };

void frob_fake_line_open(struct frob_fake_line *line, struct frob_fake_clock *clock)
{
    memset(line, 0, sizeof *line);
    line->clock = clock;
}

struct frob_serial frob_fake_serial(struct frob_fake_line *line)
{
    struct frob_serial result = { &line_operations, line };
    return result;
}

void frob_fake_send(struct frob_fake_line *line, const uint8_t *bytes, size_t count,
                    int64_t delay_ns)
{
    struct frob_fake_queue *queue = &line->to_driver;
    int64_t arrive = line->clock->now_ns + delay_ns;
    if (queue->count > 0) {
        size_t last = (queue->first + queue->count - 1) % FROB_FAKE_ROOM;
        if (queue->arrive_ns[last] > arrive)
            arrive = queue->arrive_ns[last];
    }
    for (size_t i = 0; i < count; i++)
        put(queue, bytes[i], arrive);
}

size_t frob_fake_receive(struct frob_fake_line *line, uint8_t *bytes, size_t room)
{
    return take(&line->from_driver, bytes, room, INT64_MAX);
}
