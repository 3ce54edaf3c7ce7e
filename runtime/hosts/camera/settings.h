/* settings.h -- the user's settings for a camera: the source of its frames, its projection and its
 * pose. The settings have the same names as the keys of a camera in a world file
 * (sim/README.md). */
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

/* The settings, in the order of the enum. On the command line, their names follow the camera's
 * label and a dot. */
extern const struct frob_setting camera_settings[CAMERA_SETTING_COUNT];

enum { CAMERA_LABEL_ROOM = 64 };

struct camera_options {
    char label[CAMERA_LABEL_ROOM]; /* the label in the program */
    bool has_tags;                 /* whether to look for tags in its frames */
    /* A device, an address, a folder, a pipe or a file; NULL: not set. */
    const char *source;
    double settings[CAMERA_SETTING_COUNT];
};

/* Initializes the options with the default settings and the label, the first `length` bytes of
 * `label`. Prints a line on standard error and returns false if the label is too long. */
bool camera_options_init(struct camera_options *o, const char *label, size_t length);

/* Returns the camera's pose, and its projection for frames of this size. */
struct frob_camera camera_geometry(const struct camera_options *o, int32_t width, int32_t height);

#endif
