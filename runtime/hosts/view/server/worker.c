#include "worker.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#define LOOK_NS 4000000 /* interval at which to check a run for new instants */
#define WORK_S 0.005    /* time to work before checking for requests */

/* Waits until there is a request, or until it is time to check for new instants. The caller holds
 * the lock. */
static void wait_for_something(struct worker *worker, bool looks)
{
    struct timespec until;
    if (!looks) {
        while (worker->waiting_count == 0 && !worker->is_ending)
            pthread_cond_wait(&worker->asked, &worker->lock);
        return;
    }
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_nsec += LOOK_NS;
    if (until.tv_nsec >= 1000000000) {
        until.tv_nsec -= 1000000000;
        until.tv_sec++;
    }
    while (worker->waiting_count == 0 && !worker->is_ending &&
           pthread_cond_timedwait(&worker->asked, &worker->lock, &until) == 0)
        continue;
}

/* Takes the oldest request; returns false if there is none. The caller holds the lock. */
static bool take(struct worker *worker, struct job *job)
{
    if (worker->waiting_count == 0)
        return false;
    *job = worker->waiting[0];
    worker->waiting_count--;
    memmove(worker->waiting, worker->waiting + 1, worker->waiting_count * sizeof *worker->waiting);
    return true;
}

static void answer(struct worker *worker, struct job *job)
{
    view_answer(worker->view, job->request, &job->answer);
    free(job->request);
    pthread_mutex_lock(&worker->lock);
    worker->done[worker->done_count++] = *job;
    pthread_mutex_unlock(&worker->lock);
    worker->wake();
}

static void tell(struct worker *worker)
{
    struct buffer news = { 0 };
    view_news(worker->view, &news);
    pthread_mutex_lock(&worker->lock);
    buffer_free(&worker->news);
    worker->news = news;
    worker->has_news = true;
    pthread_mutex_unlock(&worker->lock);
    worker->wake();
}

static void *work(void *context)
{
    struct worker *worker = (struct worker *)context;
    enum view_work todo = VIEW_GOES_ON;
    for (;;) {
        struct job job = { 0 };
        bool has_job, ends;
        pthread_mutex_lock(&worker->lock);
        if (todo == VIEW_LOOKS || todo == VIEW_RESTS)
            wait_for_something(worker, todo == VIEW_LOOKS);
        has_job = !view_is_reading(worker->view) && take(worker, &job);
        ends = worker->is_ending;
        pthread_mutex_unlock(&worker->lock);
        if (has_job)
            answer(worker, &job);
        if (ends)
            return NULL;
        todo = view_work(worker->view, WORK_S);
        if (view_has_news(worker->view))
            tell(worker);
    }
}

bool worker_start(struct worker *worker, struct view *view, void (*wake)(void))
{
    pthread_condattr_t by;
    memset(worker, 0, sizeof *worker);
    worker->view = view;
    worker->wake = wake;
    pthread_mutex_init(&worker->lock, NULL);
    pthread_condattr_init(&by);
    pthread_condattr_setclock(&by, CLOCK_MONOTONIC);
    pthread_cond_init(&worker->asked, &by);
    pthread_condattr_destroy(&by);
    return pthread_create(&worker->thread, NULL, work, worker) == 0;
}

void worker_end(struct worker *worker)
{
    struct job job;
    pthread_mutex_lock(&worker->lock);
    worker->is_ending = true;
    pthread_cond_signal(&worker->asked);
    pthread_mutex_unlock(&worker->lock);
    pthread_join(worker->thread, NULL);
    while (take(worker, &job))
        free(job.request);
    for (size_t i = 0; i < worker->done_count; i++)
        buffer_free(&worker->done[i].answer);
    buffer_free(&worker->news);
    pthread_cond_destroy(&worker->asked);
    pthread_mutex_destroy(&worker->lock);
}

bool worker_is_free(const struct worker *worker)
{
    return worker->jobs < WORKER_JOBS;
}

void worker_ask(struct worker *worker, unsigned long who, char *request)
{
    const struct job job = { who, request, { 0 } };
    worker->jobs++;
    pthread_mutex_lock(&worker->lock);
    worker->waiting[worker->waiting_count++] = job;
    pthread_cond_signal(&worker->asked);
    pthread_mutex_unlock(&worker->lock);
}

bool worker_answer(struct worker *worker, unsigned long *who, struct buffer *text)
{
    bool is_there;
    pthread_mutex_lock(&worker->lock);
    is_there = worker->done_count > 0;
    if (is_there) {
        worker->jobs--;
        *who = worker->done[0].who;
        *text = worker->done[0].answer;
        worker->done_count--;
        memmove(worker->done, worker->done + 1, worker->done_count * sizeof *worker->done);
    }
    pthread_mutex_unlock(&worker->lock);
    return is_there;
}

bool worker_has_news(struct worker *worker)
{
    bool has_news;
    pthread_mutex_lock(&worker->lock);
    has_news = worker->has_news;
    worker->has_news = false;
    pthread_mutex_unlock(&worker->lock);
    return has_news;
}

void worker_news(struct worker *worker, struct buffer *news)
{
    pthread_mutex_lock(&worker->lock);
    if (worker->news.length > 0)
        buffer_bytes(news, worker->news.data, worker->news.length);
    pthread_mutex_unlock(&worker->lock);
}
