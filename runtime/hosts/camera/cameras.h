/* cameras.h -- the cameras of a program, for the host that runs it. Each has a process of its own,
 * which may take as long as it likes: nothing here waits. */
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
    char seen[640];      /* what its frames are like; empty before the first */
    uint32_t given;      /* to the program */
    int64_t last_number; /* of those; -1: none yet */
    uint32_t failures;
};

/* Two of them whose frames are given in pairs, as a stereo head's. */
struct stereo_pair {
    struct camera *left, *right; /* NULL: there is none */
    struct pair pair;
    int64_t paired_ns; /* when there was a pair last, or could not have been */
    bool has_failed;
    uint32_t failures;
};

struct cameras {
    const struct frob_program *program;
    struct camera each[CAMERAS_MOST];
    size_t count;
    struct stereo_pair stereo;
    struct tag_finder
        finder; /* if tags are asked for: each process that looks for them has a copy */
    bool tells; /* also of what is as it should be */
};

/* How many cameras the program asks for, for frames or for tags in them; sets the options up, by
 * their labels. False with a line on standard error if they are too many. */
bool cameras_options(struct camera_options options[CAMERAS_MOST], size_t *count,
                     const struct frob_program *program);

/* Starts the processes, which get nothing that is opened later. False with a line on standard
 * error, also where what finds tags is not here. */
bool cameras_start(struct cameras *c, const struct frob_program *program,
                   const struct camera_options *options, size_t count, bool tells);

/* What the program sees at this instant, `now_ns` after `first_ns` on the monotonic clock: the
 * newest frames that it has not been given, and their tags; of cameras `left` and `right` those that
 * were taken together. They stay as they are until the next call. */
void cameras_look(struct cameras *c, void *input, int64_t first_ns, int64_t now_ns);

/* Passes on to standard error what the processes say. */
void cameras_hear(struct cameras *c);

/* Lines of a summary. */
void cameras_print(const struct cameras *c);

/* Also of what was started in part. */
void cameras_end(struct cameras *c);

#endif
