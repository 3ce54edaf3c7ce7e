/* answers.h -- what is answered to each request of a page (see view.h), one kind a file. All is
 * appended; numbers of signals and instants are known to be there. */
#ifndef FROB_VIEW_ANSWERS_H
#define FROB_VIEW_ANSWERS_H

#include "view.h"

/* {1 In view.c} */

/* The end of a path. */
const char *view_without_folder(const char *path);

bool view_is_live(const struct view *view);
double view_seconds_at(const struct view *view, size_t k);

/* The last instant that is not after a time; the first if all are. */
size_t view_instant_at(const struct view *view, double seconds);

/* Is anything known of it? If the program cannot be run, only what was recorded. */
bool view_knows(const struct view *view, const struct signal *signal);

void answer_refusal(struct buffer *answer, const char *why);

/* {1 In program.c} */

void answer_program(struct view *view, struct buffer *answer);

/* Members of an object: what of it changes as the program is run on; and of a run that goes
 * on, what grows. */
void answer_progress(const struct view *view, struct buffer *message);
void answer_extent(const struct view *view, struct buffer *message);

/* {1 In instant.c} */

void answer_instant(struct view *view, size_t k, struct buffer *answer);

/* {1 In claims.c} */

void answer_claims(const struct view *view, struct buffer *answer);

/* {1 In picture.c} */

/* `had`: 0, or one more than the instant of the image that the page has. */
void answer_picture(struct view *view, size_t k, size_t width, size_t had, struct buffer *answer);

/* {1 In points.c} */

void answer_series(struct view *view, size_t number, double from, double to, size_t width,
                   struct buffer *answer);
void answer_path(struct view *view, size_t x, size_t y, size_t count, struct buffer *answer);
void answer_way(struct view *view, size_t robot, size_t count, struct buffer *answer);

/* {1 In find.c} */

void answer_find(struct view *view, size_t from, const char *text, struct buffer *answer);

#endif
