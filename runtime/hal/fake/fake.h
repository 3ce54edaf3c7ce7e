/* hal/fake/fake.h -- a simulated clock and a serial line in memory, for tests.
 *
 * Time passes only when the code waits or a test advances it, so a test that simulates an hour
 * takes almost no time. The test is the other end of the line: it sends bytes that arrive
 * immediately or later, and reads what the driver wrote and when. */
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

/* Virtual time, which advances when the code sleeps or waits. */
struct frob_fake_clock {
    int64_t now_ns;
};

struct frob_clock frob_fake_time(struct frob_fake_clock *clock);

#define FROB_FAKE_ROOM 4096

/* Bytes in transit, oldest first. */
struct frob_fake_queue {
    uint8_t bytes[FROB_FAKE_ROOM];
    int64_t arrive_ns[FROB_FAKE_ROOM];
    size_t first, count;
};

struct frob_fake_line {
    struct frob_fake_clock *clock;
    struct frob_fake_queue to_driver, from_driver;
    uint32_t rate;
    bool lost;          /* the test sets this to simulate a pulled cable */
    bool blocked;       /* the test sets this to make writes time out */
    bool refuses_rates; /* the test sets this to make set_rate unsupported */
    uint32_t fastest;   /* the test sets this to make higher rates unsupported; 0: no limit */
};

/* Opens a line that has no bytes in transit and uses this clock. */
void frob_fake_line_open(struct frob_fake_line *line, struct frob_fake_clock *clock);

/* Returns the driver's end of the line. */
struct frob_serial frob_fake_serial(struct frob_fake_line *line);

/* Sends bytes from the test's end of the line. They arrive at the driver after `delay_ns`, but
 * never before bytes that were sent earlier. Bytes that do not fit are dropped. */
void frob_fake_send(struct frob_fake_line *line, const uint8_t *bytes, size_t count,
                    int64_t delay_ns);

/* Reads at most `room` of the bytes that the driver wrote; returns their number. */
size_t frob_fake_receive(struct frob_fake_line *line, uint8_t *bytes, size_t room);

#ifdef __cplusplus
}
#endif
#endif
