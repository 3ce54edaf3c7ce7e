/* control.h -- what a page may do to a run that goes on, besides looking.
 *
 *   stop       ends the run: motors at zero. From any page, at any time
 *   take       this page is the one that operates from now on
 *   pause, go, step
 *              holds a simulated run, lets it go on, or lets it take one instant
 *   speed X    how fast a simulated run goes, 0.1 to 100
 *   key CODE   a key was pressed: an event of the program's input at the next instant
 *   touch N X Y
 *              something happens to number N on the program's console, as
 *              frob_console_touch has it
 *   hold N X   button N is held, if X is 1, and let go of 0.3 s after the last time that is
 *              said; or at once, if X is 0
 *
 * Of several pages one operates, at first the oldest; all but `stop` and `take` is for it alone.
 * No request waits for anything: each is a word or two in the memory that the host shares. */
#ifndef FROB_VIEW_CONTROL_H
#define FROB_VIEW_CONTROL_H

#include "../buffer.h"

#include "../../common/ring.h"

#define CONTROL_EVENTS 100 /* in a second, at most */

struct control {
    struct ring *ring; /* NULL: the run is over, and nothing can be done to it */
    bool stopping, paused;
    double speed;
    double events;  /* that may come at once … */
    double since_s; /* … at this time */
};

void control_start(struct control *control, struct ring *ring);

/* Whether a request is one of these. */
bool control_is(const char *request);

/* Does what is asked. NULL, or why not. */
const char *control_do(struct control *control, const char *request, bool operates);

/* Appends how the run goes on, and what the page may do. */
void control_state(const struct control *control, bool operates, struct buffer *message);

#endif
