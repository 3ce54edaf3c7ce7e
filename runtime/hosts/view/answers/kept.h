/* kept.h -- stores the data that a page keeps for the next run of the program, such as its plots
 * and the sizes of its panels.
 *
 * The page determines the format of the text; the viewer stores it in a file in $XDG_STATE_HOME or
 * ~/.local/state. If the viewer cannot write the file, it keeps nothing. */
#ifndef FROB_VIEW_KEPT_H
#define FROB_VIEW_KEPT_H

#include "../buffer.h"

/* `source` is the path of the program's file; NULL if it is unknown. */
void kept_read(const char *source, struct buffer *text);
void kept_write(const char *source, const char *text);

#endif
