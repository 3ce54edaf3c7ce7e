/* cameras.h -- the cameras of a program, for the host that runs it. Each camera has its own
 * process, which may take as long as it needs, because no function here waits for it. */
#ifndef FROB_HOST_CAMERA_CAMERAS_H
#define FROB_HOST_CAMERA_CAMERAS_H

#include <stdbool.h>
#include <sys/types.h>

#include <frob/program.h>

#include "capture.h"
#include "pair.h"
#include "settings.h"

enum { CAMERAS_MOST = 4 };

struct camera {
    const struct camera_options *options;
    struct capture_way way;
    pid_t process; /* 0: none */
    int socket;
    bool works, has_failed;
    char seen[640];      /* format of its frames; empty before the first */
    uint32_t given;      /* number of frames passed to the program */
    int64_t last_number; /* number of the last frame passed; -1: none yet */
    uint32_t failures;
};

/* Two cameras whose frames are passed in pairs, such as those of a stereo head. */
struct stereo_pair {
    struct camera *left, *right; /* NULL: none */
    struct pair pair;
    int64_t paired_ns; /* last time at which a pair arrived, or a camera was not working */
    bool has_failed;
    uint32_t failures;
};

struct cameras {
    const struct frob_program *program;
    struct camera each[CAMERAS_MOST];
    size_t count;
    struct stereo_pair stereo;
    /* The tag finder, if the program uses tags; each process that looks for tags has a copy. */
    struct tag_finder finder;
    bool tells; /* whether to report working cameras, too */
};

/* Counts the cameras that the program uses, for frames or for tags, and initializes the options of
 * each camera, including its label. Prints a line on standard error and returns false if there are
 * too many. */
bool cameras_options(struct camera_options options[CAMERAS_MOST], size_t *count,
                     const struct frob_program *program);

/* Starts the processes, which do not inherit descriptors opened later. On failure, for example if
 * there is no tag finder, prints a line on standard error and returns false. */
bool cameras_start(struct cameras *c, const struct frob_program *program,
                   const struct camera_options *options, size_t count, bool tells);

/* Sets the program's camera input at this instant, `now_ns` after `first_ns` on the monotonic
 * clock: the newest frames that the program has not received yet, and their tags. Frames of the
 * cameras `left` and `right` form a pair. The frames stay valid until the next call. */
void cameras_look(struct cameras *c, void *input, int64_t first_ns, int64_t now_ns);

/* Prints messages from the camera processes on standard error. */
void cameras_hear(struct cameras *c);

/* Prints the summary's lines about the cameras. */
void cameras_print(const struct cameras *c);

/* Ends the camera processes, even if only some of them were started. */
void cameras_end(struct cameras *c);

#endif
