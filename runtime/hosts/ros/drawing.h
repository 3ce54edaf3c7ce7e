/* drawing.h -- the program's drawing, the probe `draw`, in its output: an array of events of a
 * Mark of the library's module Display. */
#ifndef FROB_HOST_ROS_DRAWING_H
#define FROB_HOST_ROS_DRAWING_H

#include <frob/program.h>

#include <stdbool.h>
#include <stddef.h>

/* Returns the drawing; NULL if the program does not draw, or was compiled without it. */
const struct frob_value *drawing_of(const struct frob_program *program);

/* Returns the program without its drawing, of which drawing_of still finds the drawing: recordings and
 * instants do not contain it. The result is the program itself if there is no drawing, or if memory runs
 * out. */
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

/* Maximum length of a label; longer ones are cut off. */
enum { DRAWING_TEXT = 256 };

/* A mark in the frame of odometry, or of the robot. */
struct drawing_mark {
    bool is_on_robot;
    enum drawing_shape shape;
    float red, green, blue;
    double at[6];            /* the numbers of the shape, in the order of the library */
    char text[DRAWING_TEXT]; /* of a label */
};

/* Reads element `i` of the drawing in an output. Returns false if it is not drawn: if there is no
 * mark, if it has another frame, or if a coordinate is not finite. */
bool drawing_read(const struct frob_value *drawing, size_t i, const void *output,
                  struct drawing_mark *mark);

#endif
