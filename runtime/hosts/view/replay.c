#include "replay.h"

#include <stdlib.h>
#include <string.h>

static unsigned char *kept_at(struct replay *replay, size_t k)
{
    return replay->kept + k / REPLAY_EVERY * replay->recording->program->state_size;
}

static void step(struct replay *replay)
{
    const struct recording *recording = replay->recording;
    recording->program->step(replay->state, recording_dt(recording, replay->next),
                             recording_input(recording, replay->next), replay->output);
    replay->next++;
}

static void compare(struct replay *replay, size_t k)
{
    const void *recorded = recording_output(replay->recording, k);
    for (size_t i = 0; i < replay->signals->count; i++) {
        const struct signal *signal = &replay->signals->all[i];
        if (signal->side == OUTPUT && replay->recording->recorded[i] &&
            !signal_values_equal(signal->value, replay->output, recorded)) {
            replay->diverged = true;
            replay->diverged_at = k;
            replay->diverged_in = signal;
            return;
        }
    }
}

bool replay_start(struct replay *replay, const struct signals *signals,
                  const struct recording *recording)
{
    const struct frob_program *program = recording->program;
    memset(replay, 0, sizeof *replay);
    replay->recording = recording;
    replay->signals = signals;
    replay->runs = recording->has_all_inputs;
    if (!replay->runs)
        return true;
    replay->state = (unsigned char *)calloc(1, program->state_size + 1);
    replay->output = (unsigned char *)calloc(1, program->output_size + 1);
    replay->kept = (unsigned char *)malloc(
        (recording->count / REPLAY_EVERY + 1) * program->state_size + 1);
    if (replay->state == NULL || replay->output == NULL || replay->kept == NULL)
        return false;
    program->reset(replay->state);
    while (replay->next < recording->count) {
        if (replay->next % REPLAY_EVERY == 0)
            memcpy(kept_at(replay, replay->next), replay->state, program->state_size);
        step(replay);
        if (!replay->diverged)
            compare(replay, replay->next - 1);
    }
    return true;
}

void replay_end(struct replay *replay)
{
    free(replay->state);
    free(replay->output);
    free(replay->kept);
}

struct moment replay_at(struct replay *replay, size_t k)
{
    const struct recording *recording = replay->recording;
    struct moment moment = { recording_input(recording, k), recording_output(recording, k), NULL };
    if (!replay->runs)
        return moment;
    if (k + 1 < replay->next || k / REPLAY_EVERY > replay->next / REPLAY_EVERY) {
        memcpy(replay->state, kept_at(replay, k), recording->program->state_size);
        replay->next = k / REPLAY_EVERY * REPLAY_EVERY;
    }
    while (replay->next <= k)
        step(replay);
    moment.output = replay->output;
    moment.state = replay->state;
    return moment;
}
