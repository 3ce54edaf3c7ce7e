/* hal/fake/fake.h -- a clock that only tests move, and a line whose bytes are
 * in memory.
 *
 * Time passes when something waits for it, so a test of an hour takes no
 * time. The other end of the line is the test: it writes bytes that arrive at
 * once or later, and reads what the driver wrote, each write with its time. */
#ifndef FROB_HAL_FAKE_H
#define FROB_HAL_FAKE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/clock.h"
#include "hal/serial.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Virtual time. Sleeping and waiting move it on. */
struct frob_fake_clock {
    int64_t now_ns;
};

struct frob_clock frob_fake_time(struct frob_fake_clock *clock);

#define FROB_FAKE_ROOM 4096

/* Bytes on their way, oldest first. */
struct frob_fake_queue {
    uint8_t bytes[FROB_FAKE_ROOM];
    int64_t arrive_ns[FROB_FAKE_ROOM];
    size_t first, count;
};

struct frob_fake_line {
    struct frob_fake_clock *clock;
    struct frob_fake_queue to_driver, from_driver;
    uint32_t rate;
    bool lost;          /* set by the test: the cable is pulled */
    bool blocked;       /* set by the test: writes find no room */
    bool refuses_rates; /* set by the test: set_rate is unsupported */
    uint32_t fastest;   /* set by the test: set_rate beyond is unsupported; 0: any rate is fine */
};

/* A line without bytes on the clock. */
void frob_fake_line_open(struct frob_fake_line *line, struct frob_fake_clock *clock);

/* The driver's end. */
struct frob_serial frob_fake_serial(struct frob_fake_line *line);

/* The test's end. Bytes arrive at the driver after `delay_ns`, never before
 * what was sent earlier; what does not fit is dropped. */
void frob_fake_send(struct frob_fake_line *line, const uint8_t *bytes, size_t count,
                    int64_t delay_ns);

/* Takes what the driver wrote, at most `room` bytes; gives their number. */
size_t frob_fake_receive(struct frob_fake_line *line, uint8_t *bytes, size_t room);

#ifdef __cplusplus
}
#endif
#endif
