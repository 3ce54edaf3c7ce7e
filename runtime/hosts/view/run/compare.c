#include "compare.h"

#include "../../common/load.h"

#include <stdio.h>
#include <string.h>

static bool begin(struct what_if *other, const struct signals *recorded, const char *file,
                  const struct csv_dialect *dialect)
{
    if (!signals_start(&other->signals, recorded->program, frob_load_columns())) {
        fprintf(stderr, "error: not enough memory for the program's signals\n");
        return false;
    }
    if (!recording_read(&other->driven, &other->signals, file, dialect))
        return false;
    while (recording_read_on(&other->driven))
        continue;
    if (!replay_start(&other->replay, &other->signals, &other->driven, &other->driven.params)) {
        fprintf(stderr, "error: not enough memory for the program's states\n");
        return false;
    }
    return true;
}

bool compare_start(struct what_if *other, const struct signals *recorded, const char *file,
                   const struct csv_dialect *dialect)
{
    what_if_end(other);
    other->is_there = other->drives = other->compares = true;
    if (!begin(other, recorded, file, dialect)) {
        what_if_end(other);
        return false;
    }
    while (!replay_is_whole(&other->replay))
        replay_advance(&other->replay);
    /* A recording from a different version of the program has outputs, but no inner signals. */
    if (other->replay.diverged)
        other->replay.runs = false;
    series_start(&other->series, &other->replay);
    return true;
}

bool compare_instant(const struct what_if *other, const struct recording *recording, size_t k,
                     size_t *there)
{
    const struct recording *its = other->replay.recording;
    const int64_t time = recording->times[k] + other->shift_ns;
    size_t low = 0, high = its->count;
    *there = k;
    if (!other->compares)
        return k < its->count;
    if (its->count == 0 || time < its->times[0])
        return false;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (its->times[middle] <= time)
            low = middle;
        else
            high = middle;
    }
    *there = low;
    /* Assumes that the last instant is as long as the one before it. */
    return low + 1 < its->count || low == 0 ||
           time - its->times[low] <= its->times[low] - its->times[low - 1];
}

void compare_find_difference(struct what_if *other, const struct recording *recording)
{
    const struct recording *its = other->replay.recording;
    other->first_in = NULL;
    for (size_t k = 0; k < recording->count; k++) {
        size_t there;
        if (!compare_instant(other, recording, k, &there))
            continue;
        for (size_t i = 0; i < other->signals.count; i++) {
            const struct signal *signal = &other->signals.all[i];
            if (signal->side == OUTPUT && recording->recorded[i] && its->recorded[i] &&
                !signal_values_equal(signal->value, recording_output(recording, k),
                                     recording_output(its, there))) {
                other->first = k;
                other->first_in = signal;
                return;
            }
        }
    }
}
