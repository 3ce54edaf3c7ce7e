/* worker.h -- the thread that answers requests, so that no answer that takes its time keeps
 * the server from hearing what is urgent.
 *
 * The view is this thread's alone while it runs. Requests and answers go through here; one
 * lock guards them, and is never held for long. */
#ifndef FROB_VIEW_WORKER_H
#define FROB_VIEW_WORKER_H

#include "../answers/view.h"

#include <pthread.h>

#define WORKER_JOBS 4 /* at a time */

/* A request; or its answer, and by whom it was asked. */
struct job {
    unsigned long who;
    char *request;
    struct buffer answer;
};

struct worker {
    struct view *view;
    void (*wake)(void); /* called when there is an answer, or news */
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t asked;
    struct job waiting[WORKER_JOBS], done[WORKER_JOBS];
    size_t waiting_count, done_count;
    size_t jobs; /* that were asked for and not taken; known to the asking thread alone */
    struct buffer news;
    bool has_news;
    bool is_ending;
};

/* Begins. `wake` is called from the thread. False if there cannot be one. */
bool worker_start(struct worker *worker, struct view *view, void (*wake)(void));
void worker_end(struct worker *worker);

/* Whether there is room for a request. */
bool worker_is_free(const struct worker *worker);

/* Hands over a request, for which there is room; it is freed later. */
void worker_ask(struct worker *worker, unsigned long who, char *request);

/* Takes an answer, which the caller frees. False if there is none. */
bool worker_answer(struct worker *worker, unsigned long *who, struct buffer *answer);

/* Whether there is news since this was asked. */
bool worker_has_news(struct worker *worker);

/* Appends the newest of what pages are told without having asked. */
void worker_news(struct worker *worker, struct buffer *news);

#endif
