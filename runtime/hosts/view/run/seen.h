/* seen.h -- the frames of a recording: whether they are there, and as they were recorded. */
#ifndef FROB_VIEW_SEEN_H
#define FROB_VIEW_SEEN_H

#include "recording.h"

/* Whether it is an event of something with an image in it. */
bool seen_is_eye(const struct frob_value *value);

/* Finds these in the program's input. False without memory. */
bool seen_start(struct recording *recording);

/* Notes that a frame of an instant is not there, or not what it was, and takes its event out of
 * the input. The program cannot be run from there on. */
void seen_lose(struct recording *recording, size_t k, unsigned char *input,
               const struct frob_value *eye, uint32_t number, bool is_there);

/* Looks whether the frames of all instants before this one are those that were recorded, at each
 * once. */
void seen_check(struct recording *recording, size_t end);

/* The newest image of the program's input at an instant or before; with a key only one that has
 * it (<frob/lens.h>). NULL if there is none. `k` becomes its instant, or 0. */
const struct frob_image *seen_image(const struct recording *recording, const int32_t *key,
                                    size_t *k);

/* The frame that is missing at an instant, or the newest before it; NULL if there is none. */
const struct lost_frame *seen_lost(const struct recording *recording, size_t k);

#endif
