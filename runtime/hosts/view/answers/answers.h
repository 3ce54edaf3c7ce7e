/* answers.h -- the answers to a page's requests (see view.h), one kind per file. Each function
 * appends its answer; the caller has already validated the signal and instant numbers. */
#ifndef FROB_VIEW_ANSWERS_H
#define FROB_VIEW_ANSWERS_H

#include "view.h"

#include "../run/compare.h"

/* ---- In view.c */

/* Returns the file name at the end of a path. */
const char *view_without_folder(const char *path);

bool view_is_live(const struct view *view);
double view_seconds_at(const struct view *view, size_t k);

/* Returns the last instant at or before a time; the first instant if all are later. */
size_t view_instant_at(const struct view *view, double seconds);

/* Returns whether the signal's values are known. If the program cannot be run, only the values of
 * recorded signals are known. */
bool view_knows(const struct view *view, const struct signal *signal);

void answer_refusal(struct buffer *answer, const char *why);

/* ---- In program.c */

void answer_program(struct view *view, struct buffer *answer);

/* answer_progress appends the members of an object that change while the program runs on the
 * recording; answer_extent appends those that grow during a live run. */
void answer_progress(const struct view *view, struct buffer *message);
void answer_extent(const struct view *view, struct buffer *message);

/* ---- In instant.c */

void answer_instant(struct view *view, size_t k, struct buffer *answer);

/* ---- In claims.c */

void answer_claims(const struct view *view, struct buffer *answer);

/* ---- In picture.c */

/* `had` is 1 plus the instant of the image that the page already has, or 0 if it has none. */
void answer_picture(struct view *view, size_t k, size_t width, size_t had, struct buffer *answer);

/* ---- In points.c */

void answer_series(struct view *view, size_t number, double from, double to, size_t width,
                   struct buffer *answer);

/* Returns the values of the signal with the same name in the edited program; NULL if there are
 * none. */
const double *view_other_numbers(struct view *view, const struct signal *signal);

/* ---- In path.c */

/* Appends the corners of the path from instant `first` on, up to about `count` of them. */
void answer_path(struct view *view, size_t x, size_t y, size_t count, size_t first,
                 struct buffer *answer);
void answer_way(struct view *view, size_t robot, size_t count, size_t first, struct buffer *answer);

/* ---- In contacts.c */

/* Appends the number of times that the first robot began to touch an object and, for each of these
 * contacts, the time and the robot's true position. */
void answer_contacts(const struct view *view, struct buffer *answer);

/* ---- In align.c */

/* Shifts the other recording so that a condition first becomes true at the same time in both
 * recordings. An empty condition aligns the starts. */
void answer_align(struct view *view, const char *condition, struct buffer *answer);

/* Appends the member `other`, which describes the recording to compare with; nothing if there is
 * none. */
void answer_other(const struct view *view, struct buffer *answer);

/* ---- In find.c */

void answer_find(struct view *view, size_t from, const char *text, struct buffer *answer);

#endif
