/* control.h -- a page's commands to a live run.
 *
 *   stop       ends the run, with the motors at zero; from any page, at any time
 *   take       lets this page operate the run, instead of any other page
 *   pause, go, step
 *              pause a simulated run, resume it, or run one instant
 *   speed X    sets the speed of a simulated run, 0.1 to 1000000
 *   key CODE   a key was pressed: an event of the program's input at the next instant
 *   touch N X Y
 *              operates control number N on the program's console; see
 *              frob_console_touch
 *   hold N X   if X is 1, button N is held until 0.3 s after the last such command; if X is 0,
 *              it is released immediately
 *
 * A command may begin with a timestamp, as `at MS COMMAND`: MS is the time in the last beat that
 * the page received. If that beat is more than CONTROL_LATE_MS old, the command is refused,
 * because a connection or a process had stalled while the command waited. The page reports this. A
 * `stop` is never late.
 *
 * If several pages are open, only one of them operates the run: at first, the oldest. Only this
 * page may send commands other than `stop` and `take`. No command blocks: each writes a word or two
 * to the memory shared with the host. */
#ifndef FROB_VIEW_CONTROL_H
#define FROB_VIEW_CONTROL_H

#include "../buffer.h"

#include "../../common/ring.h"

#define CONTROL_EVENTS 100 /* maximum number of events per second */
#define CONTROL_LATE_MS 500
#define CONTROL_TOO_LATE "the request came too late and was ignored"

struct control {
    struct ring *ring; /* the ring; NULL if the run is over and cannot be controlled */
    bool stopping, paused;
    double speed;
    double events;  /* number of events that the rate limit currently allows */
    double since_s; /* time at which `events` was last updated */
    uint32_t late;  /* the last known value of ring_late */
};

void control_start(struct control *control, struct ring *ring);

/* Returns whether a request is one of the commands above. */
bool control_is(const char *request);

/* Removes the timestamp from a command. Returns NULL, or the reason why the command is refused. */
const char *control_in_time(const char **request);

/* Executes a command. Returns NULL, or the reason why it is refused. */
const char *control_do(struct control *control, const char *request, bool operates);

/* Returns whether the host was frozen and therefore dropped events since the last call. */
bool control_was_late(struct control *control);

/* Appends the state of the run, and the page's permissions. */
void control_state(const struct control *control, bool operates, struct buffer *message);

/* Appends a beat. It contains the time, in ms. For a live run, it also contains the number of
 * seconds for which the host has been silent, and the state of the run: the state that the host
 * reported (ring.h), or `gone` if the process ended without a report. */
void control_beat(const struct control *control, bool host_has_ended, struct buffer *message);

#endif
