/* drivers/driver.h -- the interface between hosts and the driver of one kind of robot on a serial
 * line.
 *
 * A driver is a constant table. Its state for one robot is a struct of `device_size` bytes that the
 * caller owns and aligns for any type. No function allocates or recurses. No call waits, unless the
 * port has no room for the bytes to write (FROB_WRITE_PATIENCE_NS).
 *
 *   driver->start(device, settings, &serial, &clock);
 *   for (;;) {
 *       status = driver->poll(device);          // as often as bytes arrive
 *       if (status == FROB_OK && driver->sensed_ns(device) is recent) {
 *           driver->sense(device, &input);
 *           program->step(state, params, dt_ns, dt, &input, &output);
 *           driver->command(device, &output);   // limited by the caller
 *       }
 *   }
 *   driver->stop(device); driver->close(device);
 *
 * A driver does not decide when the robot must stop. core/robot.h does; hosts use it and do not
 * call drivers themselves. The wire format of a driver is in a separate module, which converts
 * bytes to structs and back and does not depend on this interface. */
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

/* A value that sources disagree on, that differs between models, or that a user may want to change.
 * Every setting is a number. */
struct frob_setting {
    const char *name; /* the name on the command line: "baud" */
    double initial;   /* NAN if the robot reports the value, or a table lists it for each model */
    double least, greatest;
    const char *meaning; /* a line for the user that states the unit */
};

struct frob_driver {
    const char *robot; /* "pioneer", as in struct frob_program */
    uint32_t rate;     /* initial bit rate of the line */
    size_t device_size;
    size_t input_size, output_size; /* sizes of the structs in <frob/ROBOT.h> */
    const struct frob_setting *settings;
    size_t setting_count;

    /* Offsets, in the output struct, of the doubles that move the robot. They are listed here so
     * that one function can limit them all. A driver that lists none limits its commands itself,
     * and replaces the first command after each start and each stop with zero. */
    const size_t *drives;
    size_t drive_count;

    /* Returns the maximum magnitude of the double at `drives[i]` for the connected robot or, if
     * none is connected, for the slowest model. */
    double (*most)(const void *device, size_t i);

    /* Starts to connect to the robot on a newly opened line. `settings` points to `setting_count`
     * values, in the order of the table. The settings, the line and the clock must stay valid until
     * the next start. The caller zeroes the device's memory before the first start, and leaves it
     * unchanged after the line has been lost, so that odometry continues from the last pose. The
     * robot's motors are at rest until the first command. */
    void (*start)(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock);

    /* Reads the bytes that have arrived, and sends the commands that are due. Returns
     * FROB_BUSY_CONNECTING until the robot can be commanded, and then FROB_OK. Returns FROB_TIMEOUT
     * if no robot answers (call start again, or give up), and FROB_LOST and FROB_REFUSED as defined
     * in status.h. */
    enum frob_status (*poll)(void *device);

    /* Returns when to poll the driver next, even if no byte arrives. INT64_MAX: only when a byte
     * arrives. If the time has passed, poll immediately. */
    int64_t (*due_ns)(const void *device);

    /* Returns the time at which the newest complete sensor reading arrived; INT64_MIN if there was
     * none. */
    int64_t (*sensed_ns)(const void *device);

    /* Fills in the robot's sensor readings. An event, such as an echo, occurs only in the first
     * input after its arrival. */
    void (*sense)(void *device, void *input);

    /* Sends the commanded values to the robot. Each is a finite number within the limits. */
    enum frob_status (*command)(void *device, const void *output);

    /* Sends the robot's strongest stop command, whatever the state of the connection. May be called
     * at any time after start. */
    enum frob_status (*stop)(void *device);

    /* Ends the session with the robot at rest. The line belongs to the caller and stays open. */
    void (*close)(void *device);

    /* Returns a description of the robot for people, such as "Pioneer p3dx, AMRISim". */
    const char *(*describe)(const void *device);

    /* Returns whether the robot was at rest according to the newest complete sensor reading. NULL
     * if its sensors do not show this; in that case, hosts wait for the maximum time that stopping
     * may take. */
    bool (*stands)(const void *device);
};

#ifdef __cplusplus
}
#endif
#endif
