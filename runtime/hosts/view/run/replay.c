#include "replay.h"

#include "seen.h"

#include <stdlib.h>
#include <string.h>

static unsigned char *kept_at(struct replay *replay, size_t k)
{
    return replay->kept + k / REPLAY_EVERY * replay->signals->program->state_size;
}

static void step(struct replay *replay)
{
    const struct recording *recording = replay->recording;
    const int64_t dt_ns = recording_dt_ns(recording, replay->next);
    replay->signals->program->step(replay->state, replay->params.values, dt_ns, (double)dt_ns / 1e9,
                                   recording_input(recording, replay->next), replay->output);
    display_see(&replay->display, replay->next, replay->output);
    replay->next++;
}

static void compare(struct replay *replay, size_t k)
{
    const void *recorded = recording_output(replay->recording, k);
    for (size_t i = 0; i < replay->compared_count; i++) {
        const struct signal *signal = replay->compared[i];
        if (!signal_values_equal(signal->value, replay->output, recorded)) {
            replay->diverged = true;
            replay->diverged_at = k;
            replay->diverged_in = signal;
            return;
        }
    }
}

/* Stores the state before instant `k`. Returns false if memory runs out. */
static bool keep(struct replay *replay, size_t k)
{
    const size_t size = replay->signals->program->state_size, number = k / REPLAY_EVERY;
    if (number >= replay->room) {
        size_t wanted = replay->recording->count / REPLAY_EVERY + 1;
        unsigned char *kept;
        struct shown *shown;
        if (wanted < 2 * replay->room)
            wanted = 2 * replay->room;
        kept = (unsigned char *)realloc(replay->kept, wanted * size + 1);
        if (kept == NULL)
            return false;
        replay->kept = kept;
        shown = (struct shown *)realloc(replay->shown, wanted * sizeof *shown);
        if (shown == NULL)
            return false;
        replay->shown = shown;
        replay->room = wanted;
    }
    memcpy(kept_at(replay, k), replay->state, size);
    replay->shown[number] = replay->display.shown;
    return true;
}

/* Finds the outputs to compare. Returns false if memory runs out. */
static bool find_compared(struct replay *replay)
{
    const struct signals *signals = replay->signals;
    replay->compared = (const struct signal **)calloc(signals->count + 1, sizeof *replay->compared);
    for (size_t i = 0; replay->compared != NULL && i < signals->count; i++)
        if (signals->all[i].side == OUTPUT && replay->recording->recorded[i])
            replay->compared[replay->compared_count++] = &signals->all[i];
    return replay->compared != NULL;
}

/* Sets the program's parameters. Ignores settings for parameters that it does not have. */
static void set_params(struct replay *replay, const struct buffer *settings)
{
    char why[PARAMS_WHY];
    for (size_t at = 0; at < settings->length; at += strlen(settings->data + at) + 1)
        params_read(&replay->params, settings->data + at, why);
}

bool replay_start(struct replay *replay, const struct signals *signals, struct recording *recording,
                  const struct buffer *settings)
{
    const struct frob_program *program = signals->program;
    memset(replay, 0, sizeof *replay);
    replay->recording = recording;
    replay->signals = signals;
    replay->runs = recording->has_all_inputs;
    if (!replay->runs)
        return true;
    if (!params_open(&replay->params, program, NULL, 0))
        return false;
    set_params(replay, settings);
    replay->state = (unsigned char *)calloc(1, program->state_size + 1);
    replay->output = (unsigned char *)calloc(1, program->output_size + 1);
    if (replay->state == NULL || replay->output == NULL || !find_compared(replay) ||
        !display_start(&replay->display, signals) || !watch_start(&replay->watch, program))
        return false;
    program->reset(replay->state, replay->params.values);
    return keep(replay, 0);
}

/* Returns the first instant that cannot be run, or the number of instants if all can be
 * run. */
static size_t last_of(const struct replay *replay)
{
    const struct recording *recording = replay->recording;
    return recording->gap < recording->count ? recording->gap : recording->count;
}

bool replay_is_whole(const struct replay *replay)
{
    return !replay->runs || replay->reached >= last_of(replay);
}

/* Restores the last state that was stored for instant `k` or an earlier one. */
static void go_back(struct replay *replay, size_t k)
{
    memcpy(replay->state, kept_at(replay, k), replay->signals->program->state_size);
    replay->next = k / REPLAY_EVERY * REPLAY_EVERY;
    replay->display.shown = replay->shown[k / REPLAY_EVERY];
}

/* Handles the output of an instant that is run for the first time. */
static void see(struct replay *replay, size_t k)
{
    if (!replay->diverged)
        compare(replay, k);
    watch_see(&replay->watch, k, replay->recording->times[k], replay->output);
}

void replay_advance(struct replay *replay)
{
    const size_t full = (replay->reached / REPLAY_EVERY + 1) * REPLAY_EVERY;
    size_t end = full < last_of(replay) ? full : last_of(replay);
    seen_check(replay->recording, end);
    end = end < last_of(replay) ? end : last_of(replay);
    if (replay->next != replay->reached)
        go_back(replay, replay->reached);
    while (replay->next < end) {
        step(replay);
        if (replay->next > replay->reached)
            see(replay, replay->next - 1);
    }
    replay->reached = end;
    if (end == full && !keep(replay, end))
        replay->runs = false;
}

void replay_end(struct replay *replay)
{
    params_close(&replay->params);
    display_end(&replay->display);
    watch_end(&replay->watch);
    free(replay->compared);
    free(replay->shown);
    free(replay->state);
    free(replay->output);
    free(replay->kept);
}

struct moment replay_at(struct replay *replay, size_t k)
{
    const struct recording *recording = replay->recording;
    struct moment moment = { recording_input(recording, k), recording_output(recording, k), NULL };
    while (replay->runs && replay->reached <= k && k < last_of(replay))
        replay_advance(replay);
    if (!replay->runs || k >= last_of(replay))
        return moment;
    if (k + 1 < replay->next || k / REPLAY_EVERY > replay->next / REPLAY_EVERY)
        go_back(replay, k);
    while (replay->next <= k)
        step(replay);
    moment.output = replay->output;
    moment.state = replay->state;
    return moment;
}

struct shown replay_shown(struct replay *replay, size_t k, const void **marks)
{
    const struct shown nothing = { NO_INSTANT, 0, NO_INSTANT };
    struct shown shown;
    *marks = NULL;
    if (replay_at(replay, k).state == NULL)
        return nothing;
    shown = replay->display.shown;
    if (shown.marks == NO_INSTANT)
        return shown;
    if (replay->display.output_of != shown.marks)
        replay_at(replay, shown.marks);
    *marks = replay->display.output;
    return shown;
}
