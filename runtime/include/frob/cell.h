/* frob/cell.h -- one value of a program's input or output as the text of one
 * cell of a trace.
 *
 * Numbers have 17 significant digits, floats as few as are read back as the same
 * float (`nan`, `inf`, `-inf`), truth values are
 * `true` and `false`, everything else stands as Frob would write it: `Just
 * 2.5`, `At (-0.3)`, `Left (1, true)`, `Pose {heading = 1}`. An event that is
 * the whole cell is empty when it does not occur, else its value. An image is its name
 * (frob/frame.h). */
#ifndef FROB_CELL_H
#define FROB_CELL_H

#include <frob/frame.h>
#include <frob/program.h>
#include <frob/text.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Appends the value that lies in `base`, the input or output struct. No
 * quoting: that is the trace's business. */
void frob_cell_write(struct frob_text *text, const struct frob_value *value, const void *base);

/* A bound for the length of a cell. */
size_t frob_cell_room(const struct frob_value *value);

/* What was wrong with a cell. */
struct frob_cell_error {
    size_t position;                 /* in bytes from the start of the cell */
    const char *expected;            /* a static text: "a number" */
    const struct frob_value *choice; /* one of its constructors was expected; or NULL */
};

/* Reads a cell into `base`, whose other bytes are left alone. All slots of a
 * sum that its constructor does not use are set to zero. Images are found in `frames`; NULL
 * where there are none. False, with the error filled in, if the text is not such a value. */
bool frob_cell_read(const char *cell, const struct frob_value *value, void *base,
                    const struct frob_frames *frames, struct frob_cell_error *error);

#ifdef __cplusplus
}
#endif
#endif
