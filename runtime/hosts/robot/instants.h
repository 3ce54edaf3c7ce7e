/* instants.h -- passes the instants of a run on to a line that publishes them (line.h): the same
 * text as in a recording. */
#ifndef FROB_HOST_ROBOT_INSTANTS_H
#define FROB_HOST_ROBOT_INSTANTS_H

#include <stdbool.h>
#include <stdint.h>

#include <frob/text.h>

#include "../common/params.h"
#include "line.h"

struct instants {
    const struct params *params;
    char *buffer; /* NULL: nothing is published */
    struct frob_text text;
    int64_t number; /* of the next instant */
    bool announced; /* the line has the columns */
};

/* If the line publishes instants, prepares for it. Prints a warning if the instants of the program
 * cannot be published: if they are too long, or contain images. */
void instants_open(struct instants *instants, const struct params *params, const struct line *line);

/* Call this when a new line was opened, so that the columns are published again. */
void instants_restart(struct instants *instants);

/* Call this when the program was reset: the next instant has the number 0. */
void instants_reset(struct instants *instants);

/* Publishes an instant. Never waits. */
void instants_put(struct instants *instants, const struct line *line, int64_t time_ns, void *in,
                  const void *out);

void instants_close(struct instants *instants);

#endif
