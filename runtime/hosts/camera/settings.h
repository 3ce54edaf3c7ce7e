/* settings.h -- what a user says of a camera: where its frames come from, how it sees, and
 * where it sits. The names are those of a camera in a world file (sim/README.md). */
#ifndef FROB_HOST_CAMERA_SETTINGS_H
#define FROB_HOST_CAMERA_SETTINGS_H

#include <stdbool.h>
#include <stddef.h>

#include <frob/image.h>

#include "drivers/driver.h"

enum camera_setting {
    CAMERA_WIDTH,
    CAMERA_HEIGHT,
    CAMERA_GREY,
    CAMERA_RATE,
    CAMERA_LATENCY,
    CAMERA_PAIR_WITHIN,
    CAMERA_FROZEN,
    CAMERA_FIELD_OF_VIEW,
    CAMERA_FOCAL_X,
    CAMERA_FOCAL_Y,
    CAMERA_CENTRE_X,
    CAMERA_CENTRE_Y,
    CAMERA_K1,
    CAMERA_K2,
    CAMERA_K3,
    CAMERA_P1,
    CAMERA_P2,
    CAMERA_AHEAD,
    CAMERA_LEFT,
    CAMERA_UP,
    CAMERA_YAW,
    CAMERA_PITCH,
    CAMERA_ROLL,
    CAMERA_SETTING_COUNT
};

/* In that order; their names come behind the camera's label and a point. */
extern const struct frob_setting camera_settings[CAMERA_SETTING_COUNT];

enum { CAMERA_LABEL_ROOM = 64 };

struct camera_options {
    char label[CAMERA_LABEL_ROOM]; /* as the program asks for it */
    bool has_tags;                 /* that are looked for in its frames */
    const char *source; /* a device, an address, a folder, a pipe or file; NULL: not said */
    double settings[CAMERA_SETTING_COUNT];
};

/* All as they are where nothing is said, of the camera whose label is so much of this one. False,
 * with a line on standard error, if there is no room for it. */
bool camera_options_init(struct camera_options *o, const char *label, size_t length);

/* How it sees, in frames of this size, and where it sits. */
struct frob_camera camera_geometry(const struct camera_options *o, int32_t width, int32_t height);

#endif
