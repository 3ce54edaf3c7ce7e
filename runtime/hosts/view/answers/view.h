/* view.h -- a page's requests about a recorded or live run, and their answers.
 *
 * A request is a line of words. An answer is JSON; for an image, a line feed and its pixels follow
 * the JSON:
 *
 *   program                    the signals, the sources and the notes
 *   instant K                  all signals at instant K
 *   cells K                    the same, but a newer request for an instant does not replace it
 *   time SECONDS               all signals at the last instant not after that time
 *   series SIGNAL FROM TO WIDTH
 *                              points for a plot of signal number SIGNAL from time FROM
 *                              to TO, in WIDTH columns
 *   path SIGNAL SIGNAL COUNT K a robot's path, whose positions are in two signals: the first
 *                              instant, the corners and the last instant, from instant K on (0 if
 *                              K is missing); at most about COUNT of them. `next` is the last
 *                              corner, from which the page can request the continuation
 *   why K SIGNAL               where the value of a signal at instant K came from (see why.h)
 *   find BEFORE CONDITION      instants at which CONDITION (see condition.h) becomes true:
 *                              the first, the last before instant BEFORE, the first after it,
 *                              their number, and the times during which it is true
 *   claims                     for each assertion of the program, its result as far as the program
 *                              has been run, and the times at which it was violated
 *   drive TEXT                 runs the program with the text TEXT in the simulator, under the
 *                              conditions of the recorded run
 *   what-if TEXT               runs the program with the text TEXT on the same inputs, and
 *                              reports the first instant at which its outputs differ; without
 *                              TEXT, removes the edited program
 *   with NAME=VALUE … what-if TEXT, with NAME=VALUE … drive TEXT
 *                              the same, with other values of its parameters
 *
 *   contacts                   when and where the simulator's first robot began to touch an object
 *   way ROBOT COUNT K          the same as `path`, for the true positions of the simulator's robot
 *                              number ROBOT
 *
 *   picture K WIDTH HAS        the image shown at instant K, or else the camera's last image,
 *                              with up to WIDTH columns; if K is `newest`, the newest image.
 *                              HAS is one more than the instant of the image that the page
 *                              already has, which is then not sent again; 0 if it has none
 *
 *   align CONDITION            shifts the other recording so that CONDITION first becomes true at
 *                              the same time in both; without CONDITION, aligns the starts
 *
 *   keep TEXT                  keeps TEXT for the next page of this program (see kept.h)
 *
 *   more                       the page has drawn the last news and is ready for more
 *
 * While there is an edited program or another recording, instants and series contain its values as
 * `others`, and each assertion has the edited program's result as `other`. Any other request is
 * answered by `{"is":"refused",…}` and has no effect. */
#ifndef FROB_VIEW_VIEW_H
#define FROB_VIEW_VIEW_H

#include "../run/live.h"
#include "../run/series.h"
#include "../run/what_if.h"
#include "why.h"

struct source {
    const char *name; /* without its folder */
    bool is_library;
    char *text;
};

struct view_files {
    const char *recording; /* the recording, or the file to which a live run is recorded; NULL if
                            * there is none */
    const char *other;     /* a recording to compare with; NULL if there is none */
    const char **sources;  /* the user's source files, then those of the library */
    size_t source_count;
    size_t own_count;           /* number of the user's source files */
    const char *world;          /* the world in which the robot drove; NULL if it is unknown */
    struct csv_dialect dialect; /* dialect of the recording */
    const char **params;        /* NAME=VALUE for each parameter that is set */
    size_t param_count;
    double at; /* time in seconds that pages show first */
    struct what_if_commands commands;
};

struct view {
    const struct frob_program *program;
    const struct frob_origin *origins; /* NULL: unknown */
    struct signals signals;
    struct recording recording;
    struct replay replay;
    struct series series;
    struct source *sources;
    size_t source_count;
    struct source world; /* its text is NULL if there is none */
    const struct view_files *files;
    struct what_if other;
    struct live live;
    bool has_news;
    double told; /* time of the last news, in seconds */
    size_t said; /* length of the summary already printed on standard error */
};

/* Reads the files, whose names must stay valid. `ring` is NULL unless the run is live. On failure,
 * prints a line on standard error and returns false. */
bool view_start(struct view *view, const struct frob_program *program,
                const struct frob_column *columns, const struct frob_origin *origins,
                const struct view_files *files, struct ring *ring);
/* Returns the time that pages show first, in seconds on the page's time axis. */
double view_start_time(const struct view *view);

void view_end(struct view *view);

/* The work that remains to be done while there is no request. */
enum view_work {
    VIEW_GOES_ON, /* continue immediately */
    VIEW_LOOKS,   /* check again soon, because the run is live */
    VIEW_RESTS    /* nothing */
};

/* Does some of the remaining work, for about this many seconds. */
enum view_work view_work(struct view *view, double seconds);

/* Returns whether there is news for the pages. Returns true only once for each piece of news. */
bool view_has_news(struct view *view);

/* Appends the news. For a recording, this is the instant up to which the program has been run over
 * it; for a live run, the newest instant. */
void view_news(struct view *view, struct buffer *message);

/* Reads more of the recording, and runs the program over it, for approximately this many seconds.
 * Returns false when everything has been done. */
bool view_advance(struct view *view, double seconds);

/* Returns whether the recording is still being read. Until it has been read, no request can be
 * answered. */
bool view_is_reading(const struct view *view);

/* Appends lines that say which parts of the recording do not match the program and, if known,
 * whether the program's outputs equal the recorded ones. */
void view_summary(const struct view *view, struct buffer *text);

/* Prints the summary's new lines on standard error. */
void view_say(struct view *view);

/* Appends the answer to a request. Appends nothing while the recording is still being read. */
void view_answer(struct view *view, const char *request, struct buffer *answer);

#endif
