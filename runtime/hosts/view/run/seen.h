/* seen.h -- the frames of a recording: whether they exist and are unchanged. */
#ifndef FROB_VIEW_SEEN_H
#define FROB_VIEW_SEEN_H

#include "recording.h"

/* Returns whether a value is an event that contains an image. */
bool seen_is_eye(const struct frob_value *value);

/* Finds all such events in the program's input. Returns false if memory runs out. */
bool seen_start(struct recording *recording);

/* Records that a frame of an instant is missing or has changed, and removes its event from the
 * input. The program cannot be run from there on. */
void seen_lose(struct recording *recording, size_t k, unsigned char *input,
               const struct frob_value *eye, uint32_t number, bool is_there);

/* Checks that the frames of all instants before `end` are unchanged. Each is checked only once. */
void seen_check(struct recording *recording, size_t end);

/* Returns the newest image of the program's input at instant `k` or before; with a key, the newest
 * image that has this key (<frob/lens.h>). NULL if there is none. Sets `k` to its instant, or to
 * 0. */
const struct frob_image *seen_image(const struct recording *recording, const int32_t *key,
                                    size_t *k);

/* Returns the missing frame of an instant, or the newest one before it; NULL if there is none. */
const struct lost_frame *seen_lost(const struct recording *recording, size_t k);

#endif
