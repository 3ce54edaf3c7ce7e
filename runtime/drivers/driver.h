/* drivers/driver.h -- one kind of robot behind a serial line, for hosts.
 *
 * A driver is a constant table. What it remembers about one robot is a struct
 * that the caller owns, `device_size` bytes of it, aligned for any type.
 * Nothing allocates, nothing recurses, and no call waits, except for a port
 * that has no room for what is written (FROB_WRITE_PATIENCE_NS).
 *
 *   driver->start(device, settings, &serial, &clock);
 *   for (;;) {
 *       status = driver->poll(device);          // as often as bytes arrive
 *       if (status == FROB_OK && driver->sensed_ns(device) is recent) {
 *           driver->sense(device, &input);
 *           program->step(state, dt, &input, &output);
 *           driver->command(device, &output);   // limited by the caller
 *       }
 *   }
 *   driver->stop(device); driver->close(device);
 *
 * Who must stop the robot, and when, is not decided here but in
 * core/robot.h, which hosts use instead of calling drivers themselves.
 * The wire format of a driver is a module of its own: bytes to structs and
 * back, without any of this. */
#ifndef FROB_DRIVERS_DRIVER_H
#define FROB_DRIVERS_DRIVER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/clock.h"
#include "hal/serial.h"
#include "hal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Something about a robot that sources disagree on, that differs between
 * models, or that a user may want otherwise. Every setting is a number. */
struct frob_setting {
    const char *name; /* as on the command line: "baud" */
    double initial;   /* NAN: what the robot says itself, or the table of its model */
    double least, greatest;
    const char *meaning; /* a line for the user, with the unit */
};

struct frob_driver {
    const char *robot; /* "pioneer", as in struct frob_program */
    uint32_t rate;     /* of the line when it is opened, bits per second */
    size_t device_size;
    size_t input_size, output_size; /* of the structs in <frob/ROBOT.h> */
    const struct frob_setting *settings;
    size_t setting_count;

    /* Where the numbers that move the robot are in its output struct: the
     * offset of each double. All are in this table, so that one function can
     * limit them. */
    const size_t *drives;
    size_t drive_count;

    /* The most that drive number `i` may be, either way; of the robot that is
     * connected, else of the weakest. */
    double (*most)(const void *device, size_t i);

    /* Begins to connect to the robot on a line that was just opened.
     * `settings` are `setting_count` values, in the order of the table. They, the
     * line and the clock stay where they are until the next start. The device's
     * memory is all zero at the first one; after a line that was lost it is as
     * it was, so that a place by odometry can go on. The robot's motors are at
     * rest until the first command. */
    void (*start)(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock);

    /* Reads what has arrived and writes what is due. FROB_BUSY_CONNECTING
     * until the robot can be commanded, then FROB_OK. FROB_TIMEOUT: no robot
     * answers, start again or give up. FROB_LOST and FROB_REFUSED as they say. */
    enum frob_status (*poll)(void *device);

    /* When the driver wants to be polled next even if no byte arrives. INT64_MAX:
     * not before. A time that has passed is at once, so let it move on. */
    int64_t (*due_ns)(const void *device);

    /* When the newest complete sensor reading arrived; INT64_MIN: never. */
    int64_t (*sensed_ns)(const void *device);

    /* What the robot senses. An event (an echo) is in the first input after it
     * arrived, and in no other. */
    void (*sense)(void *device, void *input);

    /* Sends what the robot shall do, every part of it a finite number within
     * the limits. */
    enum frob_status (*command)(void *device, const void *output);

    /* Sends the robot's strongest command to stand still, whatever the state
     * of the connection. May be called at any time after start. */
    enum frob_status (*stop)(void *device);

    /* Ends the session, with the robot at rest. The line stays open: it is the
     * caller's. */
    void (*close)(void *device);

    /* What is known about the robot, for a person: "Pioneer p3dx, AMRISim". */
    const char *(*describe)(const void *device);

    /* Whether the robot stood still at the newest complete sensor reading. NULL:
     * its sensors do not tell, and hosts wait for as long as it may take. */
    bool (*stands)(const void *device);
};

#ifdef __cplusplus
}
#endif
#endif
