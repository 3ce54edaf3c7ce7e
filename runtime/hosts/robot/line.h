/* line.h -- the connection to the robot: a serial line, or a socket to another process that
 * communicates with the robot. If it is lost, it is reopened. */
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

/* The requests that other programs have sent over the line. */
struct line_orders {
    bool pauses;     /* whether the program must pause, so that its time stands still */
    bool ends;       /* whether the run must end */
    uint32_t resets; /* number of resets requested so far */
};

/* How to open a line that is not a serial line. Such a line has its own command-line arguments. */
struct line_opening {
    const char *option; /* its arguments follow this option, up to `--` or the end */
    const char *usage;  /* a description of the arguments, for --help */
    const char *lost;   /* message that tells the user that the line was lost */

    /* Opens line->port. `settings` are those of the driver. On failure, nothing is open, and
     * `message`, whose size is `room`, contains a line that explains the problem. */
    enum frob_status (*open)(struct line *line, const double *settings, char *message, size_t room);

    /* Applies the events that have arrived over this line to the program's controls in the input.
     * `now_ns` is the time of the monotonic clock. NULL if the line has no such events. */
    void (*give)(void *device, const struct frob_program *program, void *input, int64_t now_ns);

    /* Returns the time on which the program's instants are based; `now_ns` is the time of the
     * monotonic clock. The result never decreases. INT64_MIN: not known yet. If the function is
     * NULL, instants are based on the monotonic clock. */
    int64_t (*time_ns)(const void *device, int64_t now_ns);

    /* Returns the requests of other programs. NULL if the line carries no requests. */
    struct line_orders (*orders)(const void *device);

    /* Publishes the text of the instant with this number or, if the number is -1, of the header
     * with the columns. Drops the text if the line is busy; never waits. NULL if the line does not
     * publish instants. */
    void (*publish)(const struct line *line, int64_t number, const char *text, size_t length);

    /* Maximum length of the text of an instant; 0 if the settings disable publishing. */
    size_t (*publish_room)(const struct line *line);

    /* Publishes the verdict on an assertion of the program: whether it fails now, whether verdicts
     * no longer count because an assumption has failed, and a description. NULL if the line does
     * not publish verdicts. */
    void (*judge)(const struct line *line, size_t claim, bool fails, bool is_void,
                  const char *fate);

    /* Sends the output of an instant to viewers. Drops it if the line is busy; never waits. NULL if
     * the line has no viewers. */
    void (*show)(const struct line *line, const void *output);

    /* Waits for the process at the other end to end. The port has already been closed. */
    void (*close)(struct line *line);
};

struct line {
    const struct line_opening *opening; /* NULL for a serial line */
    const char *const *arguments;
    size_t argument_count;
    const double *settings;
    const struct params *params; /* the program's parameters */
    pid_t process;               /* process at the other end; 0 if there is none */

    const char *device; /* the device name that the user gave */
    char lasting[512];  /* the adapter's persistent name; "" if it has none */
    uint32_t rate;
    struct frob_posix_line port; /* `fd` is -1 while the line is closed */
    int64_t retry_ns;
};

/* Initializes a serial line without opening it. */
void line_init(struct line *line, const char *device, uint32_t rate);

/* Initializes a line that is not a serial line, without opening it. The arguments, settings and
 * parameters must stay valid. */
void line_init_opening(struct line *line, const struct line_opening *opening,
                       const char *const *arguments, size_t argument_count, const double *settings,
                       const struct params *params);

/* Opens the line. An error message contains the device name that the user gave. */
enum frob_status line_open(struct line *line, char *message, size_t room);

/* Tries to reopen the line if a retry is due. Uses the adapter's persistent name if it has one.
 * Returns true if the line is open. */
bool line_reopen(struct line *line, int64_t now_ns);

void line_close(struct line *line);
bool line_is_open(const struct line *line);

#endif
