/* worker.h -- the thread that answers requests, so that a slow answer does not delay the server's
 * urgent messages.
 *
 * While the thread runs, only it uses the view. The functions below exchange requests and answers
 * with it. They are guarded by a single lock, which is held only briefly. */
#ifndef FROB_VIEW_WORKER_H
#define FROB_VIEW_WORKER_H

#include "../answers/view.h"

#include <pthread.h>

#define WORKER_JOBS 4 /* maximum number of pending requests */

/* A request, or its answer; `who` is the page that sent it. */
struct job {
    unsigned long who;
    char *request;
    struct buffer answer;
};

struct worker {
    struct view *view;
    void (*wake)(void); /* called when there is an answer or news */
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t asked;
    struct job waiting[WORKER_JOBS], done[WORKER_JOBS];
    size_t waiting_count, done_count;
    /* The number of requests whose answers have not been taken yet. Only the requesting thread
     * uses it. */
    size_t jobs;
    struct buffer news;
    bool has_news;
    bool is_ending;
};

/* Starts the thread, which calls `wake` when there is an answer or news. Returns false if it cannot
 * be started. */
bool worker_start(struct worker *worker, struct view *view, void (*wake)(void));
void worker_end(struct worker *worker);

/* Returns whether there is space for a request. */
bool worker_is_free(const struct worker *worker);

/* Queues a request, for which there must be space. The worker frees it. */
void worker_ask(struct worker *worker, unsigned long who, char *request);

/* Takes an answer, which the caller frees. Returns false if there is none. */
bool worker_answer(struct worker *worker, unsigned long *who, struct buffer *answer);

/* Returns whether there has been news since the last call. */
bool worker_has_news(struct worker *worker);

/* Appends the latest news for the pages. */
void worker_news(struct worker *worker, struct buffer *news);

#endif
