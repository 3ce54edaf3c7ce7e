/* frob/cell.h -- converts a value of a program's input or output to and from the text of one cell
 * of a trace.
 *
 * A double has 17 significant digits. A float has the fewest digits that identify it uniquely.
 * Non-finite numbers are `nan`, `inf` and `-inf`; truth values are `true` and `false`. Everything
 * else is written in Frob's syntax: `Just 2.5`, `At (-0.3)`, `Left (1, true)`, `Pose {heading =
 * 1}`. If the value of the whole cell is an event, the cell is empty when the event does not occur,
 * and contains the event's value when it does. An image is represented by its name
 * (frob/frame.h). */
#ifndef FROB_CELL_H
#define FROB_CELL_H

#include <frob/frame.h>
#include <frob/program.h>
#include <frob/text.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Appends the value stored in `base`, the input or output struct. Does not add CSV quotes;
 * frob/trace.h does. */
void frob_cell_write(struct frob_text *text, const struct frob_value *value, const void *base);

/* Returns an upper bound for the length of a cell. */
size_t frob_cell_room(const struct frob_value *value);

/* Describes why a cell could not be read. */
struct frob_cell_error {
    size_t position;      /* byte offset in the cell */
    const char *expected; /* a static string, such as "a number" */
    /* If not NULL, one of this value's constructors was expected. */
    const struct frob_value *choice;
};

/* Reads a cell into `base` and leaves the other bytes of `base` unchanged. Zeroes the slots of a
 * sum that the constructor does not use. Looks up images in `frames`, which is NULL if there are
 * none. If the text is not a value of this type, fills in `error` and returns false. */
bool frob_cell_read(const char *cell, const struct frob_value *value, void *base,
                    const struct frob_frames *frames, struct frob_cell_error *error);

#ifdef __cplusplus
}
#endif
#endif
