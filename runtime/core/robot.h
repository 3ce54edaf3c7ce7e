/* core/robot.h -- keeps a robot at rest unless moving is known to be safe. Hosts drive robots
 * through this module, never through a driver.
 *
 *   frob_robot_start(&robot, …);
 *   for (;;) {
 *       wait until bytes arrive or frob_robot_due_ns(&robot);
 *       if (frob_robot_poll(&robot) == FROB_ROBOT_READY && it is time) {
 *           frob_robot_sense(&robot, &input);
 *           program->step(state, params, dt_ns, dt, &input, &output);
 *           frob_robot_command(&robot, &output);
 *       }
 *   }
 *
 * Guarantees, for every driver and every port:
 *   - Every number that moves the robot goes through one function, which passes on only finite
 *     numbers within the robot's limits. If a number is not finite, it sets all of them to zero.
 *   - After each connection, and after the robot was stopped for one of the reasons below, the
 *     first command is zero.
 *   - When the newest sensor reading is older than patience_ns, the robot is stopped, and the stop
 *     command is repeated ten times a second until readings and commands arrive again.
 *     frob_robot_halt has the same effect.
 *   - If the reading that the program used is older than patience_ns when the command arrives, the
 *     command is dropped and the robot is stopped.
 *   - If the caller has not polled for longer than patience_ns (for example because its process
 *     was stopped), the line contains old readings. Readings that arrive within another patience_ns
 *     are ignored, and the robot stays stopped during that time.
 *   - No function waits, allocates or makes a system call. */
#ifndef FROB_CORE_ROBOT_H
#define FROB_CORE_ROBOT_H

#include <stdbool.h>

#include "drivers/driver.h"

#ifdef __cplusplus
extern "C" {
#endif

enum frob_robot_state {
    FROB_ROBOT_CONNECTING,
    FROB_ROBOT_READY, /* readings are recent enough, so the program may step */
    FROB_ROBOT_STALE, /* readings are too old; the robot is stopped */
    FROB_ROBOT_FAILED /* the connection has failed; `status` contains the reason. The caller must
                       * close the robot, and may then call frob_robot_start again */
};

/* Maximum size of a robot's output struct, in bytes. */
enum { FROB_OUTPUT_MOST = 512 };

struct frob_robot {
    const struct frob_driver *driver;
    void *device;
    struct frob_serial serial; /* a copy, because the driver keeps the pointer */
    struct frob_clock clock;
    int64_t patience_ns;
    enum frob_robot_state state;
    enum frob_status status; /* status of the last call to the driver */
    bool at_rest;            /* no command since the robot was connected or halted */
    bool rests_first;        /* whether to replace the next command with zero */
    int64_t stop_due_ns;     /* time at which to repeat the stop command while the robot is at
                              * rest */
    int64_t halted_ns;       /* time of the last frob_robot_halt */
    int64_t polled_ns;       /* time of the last frob_robot_poll; INT64_MIN if there was none yet */
    int64_t counts_from_ns;  /* readings that arrived before this time are considered too old */
    int64_t given_ns;        /* arrival time of the reading on which the next command is based;
                              * INT64_MAX if unknown */
    uint32_t connections;
    uint32_t stale; /* number of times that readings became too old */
    union {
        double aligned;
        unsigned char bytes[FROB_OUTPUT_MOST];
    } limited; /* a copy of the last output, after frob_robot_limit */
};

/* Starts to connect. Copies what `serial` and `clock` point to; `settings` must stay valid.
 * `patience_ns` is the maximum age of a reading, greater than zero. Keeps the data in `device` from
 * earlier connections. */
void frob_robot_start(struct frob_robot *robot, const struct frob_driver *driver, void *device,
                      const double *settings, const struct frob_serial *serial,
                      const struct frob_clock *clock, int64_t patience_ns);

/* Reads the bytes that have arrived, sends the commands that are due, and stops the robot if its
 * readings are too old. */
enum frob_robot_state frob_robot_poll(struct frob_robot *robot);

/* Returns when to poll next, even if no byte arrives. */
int64_t frob_robot_due_ns(const struct frob_robot *robot);

/* Writes the latest reading to `input`. Call it only while the robot is READY. The next command is
 * assumed to be computed from this reading. */
void frob_robot_sense(struct frob_robot *robot, void *input);

/* Sends the output, limited by frob_robot_limit. Drops it while the robot is not READY. */
enum frob_status frob_robot_command(struct frob_robot *robot, const void *output);

/* Stops the robot immediately and keeps it stopped until the next command. */
enum frob_status frob_robot_halt(struct frob_robot *robot);

/* Returns whether sensor readings have shown the robot to be at rest since it was halted. */
bool frob_robot_stands(const struct frob_robot *robot);

/* Stops the robot and ends its session. The caller must close the line. */
void frob_robot_close(struct frob_robot *robot);

/* If any of the driver's `drives` in `output` is not finite, sets all of them to zero. Otherwise,
 * clamps each to the maximum that the driver reports for it. Returns true if it changed any. No
 * other function limits them. */
bool frob_robot_limit(const struct frob_driver *driver, const void *device, void *output);

#ifdef __cplusplus
}
#endif
#endif
