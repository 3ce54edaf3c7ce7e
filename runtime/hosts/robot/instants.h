/* instants.h -- sends the instants of a run, as the text of a recording, to a line that publishes
 * them (line.h). */
#ifndef FROB_HOST_ROBOT_INSTANTS_H
#define FROB_HOST_ROBOT_INSTANTS_H

#include <stdbool.h>
#include <stdint.h>

#include <frob/text.h>

#include "../common/params.h"
#include "line.h"

struct instants {
    const struct params *params;
    char *buffer; /* buffer for `text`; NULL if nothing is published */
    struct frob_text text;
    int64_t number; /* number of the next instant */
    bool announced; /* whether the columns have been published on the line */
};

/* Prepares to publish instants, if the line publishes any. Prints a warning if the program's
 * instants cannot be published because they are too long or contain images. */
void instants_open(struct instants *instants, const struct params *params, const struct line *line);

/* Must be called when the line has been opened, so that the columns are published again. */
void instants_restart(struct instants *instants);

/* Must be called when the program has been reset, so that the next instant gets the number 0. */
void instants_reset(struct instants *instants);

/* Publishes an instant. Never waits. */
void instants_put(struct instants *instants, const struct line *line, int64_t time_ns, void *in,
                  const void *out);

void instants_close(struct instants *instants);

#endif
