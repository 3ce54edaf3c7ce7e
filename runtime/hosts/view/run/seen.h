/* seen.h -- checks that the frames of a recording exist and are unchanged. */
#ifndef FROB_VIEW_SEEN_H
#define FROB_VIEW_SEEN_H

#include "recording.h"

/* Returns whether a value is an event that contains an image. */
bool seen_is_eye(const struct frob_value *value);

/* Finds all events in the program's input that contain an image, and stores them in `eyes`. Returns
 * false if memory runs out. */
bool seen_start(struct recording *recording);

/* Records that a frame is missing at instant `k` or has changed, and removes the frame's event from
 * the input. The program cannot be run for this or any later instant. */
void seen_lose(struct recording *recording, size_t k, unsigned char *input,
               const struct frob_value *eye, uint32_t number, bool is_there);

/* Checks that the frames of all instants before `end` are unchanged. Each is checked only once. */
void seen_check(struct recording *recording, size_t end);

/* Returns the newest image in the program's input up to instant `k`. If a key is given, returns
 * the newest image with this key (<frob/lens.h>). Returns NULL if there is none. Sets `k` to the
 * instant of the image, or to 0. */
const struct frob_image *seen_image(const struct recording *recording, const int32_t *key,
                                    size_t *k);

/* Returns the newest missing or changed frame up to instant `k`; NULL if there is none. */
const struct lost_frame *seen_lost(const struct recording *recording, size_t k);

#endif
