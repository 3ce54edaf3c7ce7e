/* core/robot.h -- a robot that stands still whenever it is not known to be
 * safe to move. Hosts drive robots through this, never through a driver.
 *
 *   frob_robot_start(&robot, …);
 *   for (;;) {
 *       wait until bytes arrive or frob_robot_due_ns(&robot);
 *       if (frob_robot_poll(&robot) == FROB_ROBOT_READY && it is time) {
 *           frob_robot_sense(&robot, &input);
 *           program->step(state, dt, &input, &output);
 *           frob_robot_command(&robot, &output);
 *       }
 *   }
 *
 * What holds here, for every driver and every port:
 *   - Every number that moves the robot goes through one function, which lets
 *     only finite numbers within the robot's limits pass; a number that is not
 *     finite makes all of them zero.
 *   - The first command after any connection is zero.
 *   - When the newest sensor reading is older than the patience, the robot is
 *     stopped, and told so again ten times a second, until readings and
 *     commands come again. The same after frob_robot_halt.
 * Nothing here waits, allocates or calls the system. */
#ifndef FROB_CORE_ROBOT_H
#define FROB_CORE_ROBOT_H

#include <stdbool.h>

#include "drivers/driver.h"

#ifdef __cplusplus
extern "C" {
#endif

enum frob_robot_state {
    FROB_ROBOT_CONNECTING,
    FROB_ROBOT_READY, /* readings are fresh: the program may step */
    FROB_ROBOT_STALE, /* readings are too old; the robot is stopped */
    FROB_ROBOT_FAILED /* `status` says why; close it, perhaps start again */
};

/* The output struct of any robot fits. */
enum { FROB_OUTPUT_MOST = 512 };

struct frob_robot {
    const struct frob_driver *driver;
    void *device;
    struct frob_serial serial; /* what the driver is given stays as long as this */
    struct frob_clock clock;
    int64_t patience_ns;
    enum frob_robot_state state;
    enum frob_status status; /* of the last call to the driver */
    bool at_rest;            /* no command since it was connected or halted */
    bool connected_now;      /* the next command is the first of a connection */
    int64_t stop_due_ns;     /* while at rest */
    int64_t halted_ns;       /* the last frob_robot_halt */
    uint32_t connections;
    uint32_t stale; /* how often readings became too old */
    union {
        double aligned;
        unsigned char bytes[FROB_OUTPUT_MOST];
    } limited; /* what was commanded last */
};

/* Begins to connect. What `serial` and `clock` point to is copied; `settings` must
 * stay. `patience_ns` is how old a reading may be; it is greater
 * than zero. Whatever `device` knows from earlier connections is kept. */
void frob_robot_start(struct frob_robot *robot, const struct frob_driver *driver, void *device,
                      const double *settings, const struct frob_serial *serial,
                      const struct frob_clock *clock, int64_t patience_ns);

/* Reads what has arrived, sends what is due, and looks at the clock. */
enum frob_robot_state frob_robot_poll(struct frob_robot *robot);

/* When it wants to be polled even if no byte arrives. */
int64_t frob_robot_due_ns(const struct frob_robot *robot);

/* What the robot senses, while it is READY. */
void frob_robot_sense(struct frob_robot *robot, void *input);

/* Sends the output, limited; while the robot is not READY it is dropped. */
enum frob_status frob_robot_command(struct frob_robot *robot, const void *output);

/* Stops the robot at once, and keeps it so until the next command. */
enum frob_status frob_robot_halt(struct frob_robot *robot);

/* Whether the robot has been seen to stand still since it was halted. */
bool frob_robot_stands(const struct frob_robot *robot);

/* Stops the robot and ends its session. The line is the caller's to close. */
void frob_robot_close(struct frob_robot *robot);

/* The one clamp: makes the drives of an output finite and at most what the
 * driver's robot may be told. True if it changed something. */
bool frob_robot_limit(const struct frob_driver *driver, const void *device, void *output);

#ifdef __cplusplus
}
#endif
#endif
