/* view.h -- what a page asks of a run, recorded or going on, and the answers.
 *
 * A request is a line of words, an answer JSON, of a picture with a line feed and its pixels after it:
 *
 *   program                    what there is: signals, sources, notes
 *   instant K                  all signals at instant K
 *   time SECONDS               likewise, at the last instant not after that time
 *   series SIGNAL FROM TO WIDTH
 *                              points for a plot of signal number SIGNAL from time FROM
 *                              to TO, on WIDTH columns
 *   path SIGNAL SIGNAL COUNT   two signals at up to COUNT instants, evenly over the run
 *   why K SIGNAL               where the value of a signal at instant K came from (see why.h)
 *   find BEFORE CONDITION      instants at which CONDITION (see condition.h) begins to hold:
 *                              the first, the last before instant BEFORE, the first after it,
 *                              how many there are, and the times for which it holds
 *   claims                     the program's assertions: what became of each, as far as the program
 *                              has been run, and at which times it was violated
 *   drive TEXT                 the program as TEXT has it, run in the simulator as the recorded one
 *                              was
 *   what-if TEXT               the program as TEXT has it, run on the same inputs: from which
 *                              instant on its outputs are others; without TEXT, no more of it
 *   with NAME=VALUE … what-if TEXT, with NAME=VALUE … drive TEXT
 *                              likewise, with other values of its parameters
 *
 *   way ROBOT COUNT            where robot number ROBOT of a simulator really was, at up to
 *                              COUNT instants, evenly over the run
 *
 *   picture K WIDTH HAS        what is shown of an image at instant K, or what the camera saw
 *                              last; with up to WIDTH columns; K `newest`: the newest one. HAS:
 *                              0, or one more than the instant of the image that the page has, so
 *                              that it is not sent again
 *
 *   more                       the last news was drawn: there may be other
 *
 * While there is such a program, instants and series have the `others` of its values, and each
 * assertion has its `other` fate.
 * What is no request is answered by `{"is":"refused",…}`, and nothing else happens. */
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
    const char *recording; /* of a run that goes on: what it is recorded in, or NULL */
    const char **sources;  /* the user's, then … */
    size_t source_count;
    size_t own_count;    /* … from here on those of the library */
    const char *world;   /* that the robot may have driven in; NULL: none */
    const char **params; /* values of the program's parameters, NAME=VALUE each */
    size_t param_count;
    double at; /* the time that pages show at first, in seconds */
    struct what_if_commands commands;
};

struct view {
    const struct frob_program *program;
    const struct frob_origin *origins; /* NULL: they are not known */
    struct signals signals;
    struct recording recording;
    struct replay replay;
    struct series series;
    struct source *sources;
    size_t source_count;
    struct source world; /* text NULL: none */
    const struct view_files *files;
    struct what_if other;
    struct live live;
    bool has_news;
    double told; /* when there last was news; seconds */
    size_t said; /* so much of the summary was said on standard error */
};

/* Reads the files, whose names are to stay; with a ring, for a run that goes on. False with
 * a line on standard error. */
bool view_start(struct view *view, const struct frob_program *program,
                const struct frob_column *columns, const struct frob_origin *origins,
                const struct view_files *files, struct ring *ring);
void view_end(struct view *view);

/* What is to be done when nobody asks for anything. */
enum view_work {
    VIEW_GOES_ON, /* more of the same, now */
    VIEW_LOOKS,   /* look again soon: the run goes on */
    VIEW_RESTS    /* nothing */
};

/* Does some of it, for about so many seconds. */
enum view_work view_work(struct view *view, double seconds);

/* Whether there is something that pages are to be told without having asked; true once. */
bool view_has_news(struct view *view);

/* Appends that: of a recording, how far the program has been run over it; of a run that
 * goes on, its newest instant. */
void view_news(struct view *view, struct buffer *message);

/* Reads more of the recording, and runs the program over it, for about so many seconds. False
 * if that has been done with all of it. */
bool view_advance(struct view *view, double seconds);

/* Whether not all of a recording has been read: then nothing can be answered yet. */
bool view_is_reading(const struct view *view);

/* Appends what does not fit, and whether outputs are the recorded ones as far as is known.
 * Lines. */
void view_summary(const struct view *view, struct buffer *text);

/* Says on standard error what of this has not been said there. */
void view_say(struct view *view);

/* Appends the answer to a request, unless the recording is still being read. */
void view_answer(struct view *view, const char *request, struct buffer *answer);

#endif
