#include "settings.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const struct frob_setting camera_settings[CAMERA_SETTING_COUNT] = {
    { "width", 0, 0, FROB_IMAGE_SIDE, "pixels; 0: as delivered by the source" },
    { "height", 0, 0, FROB_IMAGE_SIDE, "pixels; 0: as delivered by the source" },
    { "grey", 0, 0, 1, "1: grey frames; raw frames then have one byte per pixel" },
    { "rate", 30, 0.1, 200, "frame rate in Hz, used for files and requested from devices" },
    { "latency", 0, 0, 10, "time in s from a frame's exposure to its arrival" },
    { "pair_within", NAN, 0, 10,
      "maximum time in s between the left and right frames of a pair; the default is 0.6 periods" },
    { "frozen", 1, 0, 3600,
      "time in s after which a camera with identical frames counts as frozen; 0: never" },
    { "field_of_view_deg", 60, 1, 175, "horizontal" },
    { "focal_x", NAN, 1, 1e6, "pixels, from calibration, instead of the field of view" },
    { "focal_y", NAN, 1, 1e6, "pixels; the default is focal_x" },
    { "centre_x", NAN, -1e4, 1e4,
      "pixels; position of the optical axis; the default is the centre" },
    { "centre_y", NAN, -1e4, 1e4, "pixels; the default is the centre" },
    { "k1", 0, -100, 100, "distortion, as in OpenCV" },
    { "k2", 0, -100, 100, "" },
    { "k3", 0, -100, 100, "" },
    { "p1", 0, -100, 100, "" },
    { "p2", 0, -100, 100, "" },
    { "ahead", 0.12, -10, 10, "m from the point on the floor between the wheels" },
    { "left", 0, -10, 10, "m" },
    { "up", 0.27, 0, 10, "m" },
    { "yaw_deg", 0, -360, 360, "turned to the left" },
    { "pitch_deg", 0, -90, 90, "tilted down" },
    { "roll_deg", 0, -360, 360, "clockwise as seen from behind" },
};

bool camera_options_init(struct camera_options *o, const char *label, size_t length)
{
    if (length >= sizeof o->label) {
        fprintf(stderr, "error: the camera label `%.*s` is longer than the maximum of %d bytes\n",
                (int)length, label, CAMERA_LABEL_ROOM - 1);
        return false;
    }
    memset(o, 0, sizeof *o);
    memcpy(o->label, label, length);
    for (size_t i = 0; i < CAMERA_SETTING_COUNT; i++)
        o->settings[i] = camera_settings[i].initial;
    return true;
}

static double radians(double degrees)
{
    return degrees * 0.017453292519943295;
}

static double given_or(double x, double otherwise)
{
    return isnan(x) ? otherwise : x;
}

struct frob_camera camera_geometry(const struct camera_options *o, int32_t width, int32_t height)
{
    const double *s = o->settings;
    struct frob_camera c;
    /* A pinhole camera with this horizontal field of view. */
    c.focal_x =
        given_or(s[CAMERA_FOCAL_X], 0.5 * width / tan(0.5 * radians(s[CAMERA_FIELD_OF_VIEW])));
    c.focal_y = given_or(s[CAMERA_FOCAL_Y], c.focal_x);
    c.centre_x = given_or(s[CAMERA_CENTRE_X], 0.5 * (width - 1));
    c.centre_y = given_or(s[CAMERA_CENTRE_Y], 0.5 * (height - 1));
    c.k1 = s[CAMERA_K1];
    c.k2 = s[CAMERA_K2];
    c.k3 = s[CAMERA_K3];
    c.p1 = s[CAMERA_P1];
    c.p2 = s[CAMERA_P2];
    c.x_m = s[CAMERA_AHEAD];
    c.y_m = s[CAMERA_LEFT];
    c.z_m = s[CAMERA_UP];
    c.yaw_rad = radians(s[CAMERA_YAW]);
    c.pitch_rad = radians(s[CAMERA_PITCH]);
    c.roll_rad = radians(s[CAMERA_ROLL]);
    return c;
}
