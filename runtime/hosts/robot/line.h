/* line.h -- the connection to the robot, which is reopened after a loss: a serial line, or a socket
 * to another process that communicates with the robot. */
#ifndef FROB_HOST_ROBOT_LINE_H
#define FROB_HOST_ROBOT_LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#include <frob/program.h>

#include "hal/posix/serial.h"

struct line;
struct params;

/* What other programs order over the line. */
struct line_orders {
    bool pauses;     /* the program does not step, and its time stands still */
    bool ends;       /* the run ends */
    uint32_t resets; /* how often the program was told to begin again */
};

/* How to open a line that is not a serial line. It has its own arguments on the command line. */
struct line_opening {
    const char *option; /* its arguments follow this option, up to `--` or the end */
    const char *usage;  /* describes them, for --help */
    const char *lost;   /* tells the user that the line was lost */

    /* Opens line->port. `settings` are those of the driver. On failure nothing is open, and
     * `message`, of size `room`, explains the problem in one line. */
    enum frob_status (*open)(struct line *line, const double *settings, char *message, size_t room);

    /* Sets the events of the program's controls that come over this line, for this instant;
     * `now_ns` is the monotonic clock. NULL: there are none. */
    void (*give)(void *device, const struct frob_program *program, void *input, int64_t now_ns);

    /* Returns the time that the program's instants follow; `now_ns` is the monotonic clock. It
     * never goes back. INT64_MIN: not known yet. NULL: the monotonic clock. */
    int64_t (*time_ns)(const void *device, int64_t now_ns);

    /* NULL: there are no orders. */
    struct line_orders (*orders)(const void *device);

    /* Publishes a text: the instant with this number, or the columns of the instants for -1. Drops
     * it if the line is busy; never waits. NULL: the line does not publish instants. */
    void (*publish)(const struct line *line, int64_t number, const char *text, size_t length);

    /* Maximum length of these texts, or 0 if the settings turn them off. */
    size_t (*publish_room)(const struct line *line);

    /* Publishes the verdict on an assertion of the program: whether it fails now, whether
     * verdicts no longer count because an assumption has failed, and what happened to it. NULL: the
     * line does not publish verdicts. */
    void (*judge)(const struct line *line, size_t claim, bool fails, bool is_void,
                  const char *fate);

    /* Shows the output of an instant to viewers. Drops it if the line is busy; never waits. NULL: the
     * line has no viewers. */
    void (*show)(const struct line *line, const void *output);

    /* Waits until the process at the other end has ended. The port is closed. */
    void (*close)(struct line *line);
};

struct line {
    const struct line_opening *opening; /* NULL: a serial line */
    const char *const *arguments;
    size_t argument_count;
    const double *settings;
    const struct params *params; /* of the program */
    pid_t process;               /* at the other end; 0: none */

    const char *device; /* as the user named it */
    char lasting[512];  /* the adapter's persistent name; "" if none */
    uint32_t rate;
    struct frob_posix_line port; /* fd is -1 while it is closed */
    int64_t retry_ns;
};

/* Initializes a serial line without opening it. */
void line_init(struct line *line, const char *device, uint32_t rate);

/* Initializes another line without opening it. The arguments, settings and parameters must stay
 * valid. */
void line_init_opening(struct line *line, const struct line_opening *opening,
                       const char *const *arguments, size_t argument_count, const double *settings,
                       const struct params *params);

/* Opens the line. The message uses the device name that the user gave. */
enum frob_status line_open(struct line *line, char *message, size_t room);

/* Tries to reopen the line if a retry is due, also under the adapter's current name. Returns true
 * if it is open. */
bool line_reopen(struct line *line, int64_t now_ns);

void line_close(struct line *line);
bool line_is_open(const struct line *line);

#endif
