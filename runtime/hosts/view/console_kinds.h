/* console_kinds.h -- the kinds of controls on a program's console, with the names that the page
 * uses.
 *
 * This is the only list: page/build.sh generates the page's list from it (one kind per line). C or
 * TypeScript code that does not handle every kind does not compile. */
#ifndef FROB_VIEW_CONSOLE_KINDS_H
#define FROB_VIEW_CONSOLE_KINDS_H

#define CONSOLE_KINDS(KIND)     \
    KIND(FROB_BUTTON, "button") \
    KIND(FROB_HOLD, "hold")     \
    KIND(FROB_KNOB, "knob")     \
    KIND(FROB_TOGGLE, "toggle") \
    KIND(FROB_MAP, "map")       \
    KIND(FROB_CAMERA, "camera") \
    KIND(FROB_TAGS, "tags")     \
    KIND(FROB_LIDAR, "lidar")   \
    KIND(FROB_IMU, "imu")

#endif
