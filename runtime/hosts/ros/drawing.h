/* drawing.h -- finds the program's drawing in its output. It is the probe `draw`, an array of
 * events whose values have the type Mark of the library's module Display. */
#ifndef FROB_HOST_ROS_DRAWING_H
#define FROB_HOST_ROS_DRAWING_H

#include <frob/program.h>

#include <stdbool.h>
#include <stddef.h>

/* Returns the drawing; NULL if the program does not draw, or if it was compiled without the
 * drawing. */
const struct frob_value *drawing_of(const struct frob_program *program);

/* Returns a program whose output does not contain the drawing, so that recordings and published
 * instants do not contain it either. drawing_of still finds it. Returns the program itself if there
 * is no drawing, or if memory runs out. */
const struct frob_program *drawing_hide(const struct frob_program *program);

/* Returns the maximum number of marks. */
size_t drawing_room(const struct frob_value *drawing);

enum drawing_shape {
    DRAWING_LINE,
    DRAWING_ARROW,
    DRAWING_CIRCLE,
    DRAWING_BOX,
    DRAWING_CROSS,
    DRAWING_LABEL
};

/* Maximum size of a label, including the NUL. Longer labels are truncated. */
enum { DRAWING_TEXT = 256 };

/* A mark, in the odometry frame or the robot frame. */
struct drawing_mark {
    bool is_on_robot;
    enum drawing_shape shape;
    float red, green, blue;
    double at[6];            /* the numbers of the shape, in the order in which the library declares
                              * them */
    char text[DRAWING_TEXT]; /* text of a label */
};

/* Reads element `i` of the drawing in an output. Returns false if there is nothing to draw: there
 * is no mark, its frame is unknown, or a coordinate is not finite. */
bool drawing_read(const struct frob_value *drawing, size_t i, const void *output,
                  struct drawing_mark *mark);

#endif
