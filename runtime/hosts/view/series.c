#include "series.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void series_start(struct series *series, struct replay *replay)
{
    memset(series, 0, sizeof *series);
    series->replay = replay;
}

void series_end(struct series *series)
{
    for (size_t i = 0; i < SERIES_KEPT; i++)
        free(series->kept[i].numbers);
}

/* A place for the numbers of one more signal: a free one, or else that of the signal that was
 * asked for the longest ago. NULL without memory. */
static struct kept_series *place_for(struct series *series, const struct signal *signal)
{
    struct kept_series *place = &series->kept[0];
    for (size_t i = 1; i < SERIES_KEPT; i++)
        if (series->kept[i].used < place->used)
            place = &series->kept[i];
    if (place->numbers == NULL)
        place->numbers =
            (double *)malloc(series->replay->recording->count * sizeof *place->numbers);
    if (place->numbers == NULL)
        return NULL;
    place->signal = signal;
    place->used = series->uses;
    return place;
}

static struct kept_series *find(struct series *series, const struct signal *signal)
{
    for (size_t i = 0; i < SERIES_KEPT; i++)
        if (series->kept[i].numbers != NULL && series->kept[i].signal == signal)
            return &series->kept[i];
    return NULL;
}

/* Is a signal in the recording, so that the program need not be run for it? Outputs are as
 * long as none was found to be another. */
static bool is_recorded(const struct replay *replay, const struct signal *signal)
{
    const size_t number = (size_t)(signal - replay->signals->all);
    if (signal->side == INPUT || !replay->runs)
        return true;
    return signal->side == OUTPUT && replay->recording->program == replay->signals->program &&
           replay->recording->recorded[number] && !replay->diverged;
}

static void read_out(struct replay *replay, const struct signal *signal, double *numbers)
{
    const struct recording *recording = replay->recording;
    for (size_t k = 0; k < recording->count; k++) {
        struct moment moment = { recording_input(recording, k), recording_output(recording, k),
                                 NULL };
        numbers[k] = signal_number(replay->signals, signal, &moment);
    }
}

/* Of several signals in one run over the recording. */
static void run_over(struct replay *replay, struct kept_series *const *wanted, size_t count)
{
    for (size_t k = 0; k < replay->recording->count; k++) {
        struct moment moment = replay_at(replay, k);
        for (size_t i = 0; i < count; i++)
            wanted[i]->numbers[k] = signal_number(replay->signals, wanted[i]->signal, &moment);
    }
}

/* A signal that the program must be run for, and all modes with it: a page asks for them
 * together. */
static struct kept_series *compute(struct series *series, const struct signal *signal)
{
    const struct signals *signals = series->replay->signals;
    struct kept_series *wanted[SERIES_KEPT / 2];
    size_t count = 0;
    wanted[count] = place_for(series, signal);
    if (wanted[count] == NULL)
        return NULL;
    count++;
    for (size_t i = 0; i < signals->count && count < SERIES_KEPT / 2; i++) {
        const struct signal *other = &signals->all[i];
        if (other->side != MODE || find(series, other) != NULL)
            continue;
        wanted[count] = place_for(series, other);
        if (wanted[count] == NULL)
            break;
        count++;
    }
    run_over(series->replay, wanted, count);
    return wanted[0];
}

const double *series_of(struct series *series, const struct signal *signal)
{
    struct kept_series *kept = find(series, signal);
    series->uses++;
    if (kept == NULL && is_recorded(series->replay, signal)) {
        kept = place_for(series, signal);
        if (kept != NULL)
            read_out(series->replay, signal, kept->numbers);
    } else if (kept == NULL) {
        kept = compute(series, signal);
    }
    if (kept == NULL)
        return NULL;
    kept->used = series->uses;
    return kept->numbers;
}

void series_forget(struct series *series)
{
    struct replay *replay = series->replay;
    series_end(series);
    series_start(series, replay);
}

/* Of one column of the picture, with at least five instants. */
static void visit_extremes(const double *numbers, size_t from, size_t to,
                           void (*visit)(void *context, size_t k), void *context)
{
    size_t least = from, greatest = from;
    for (size_t k = from; k < to; k++) {
        if (isnan(numbers[least]) || numbers[k] < numbers[least])
            least = k;
        if (isnan(numbers[greatest]) || numbers[k] > numbers[greatest])
            greatest = k;
    }
    const size_t points[] = { from, least < greatest ? least : greatest,
                              least < greatest ? greatest : least, to - 1 };
    for (size_t i = 0; i < 4; i++)
        if (i == 0 || points[i] > points[i - 1])
            visit(context, points[i]);
}

void series_visit(const double *numbers, size_t from, size_t to, size_t width,
                  void (*visit)(void *context, size_t k), void *context)
{
    const size_t length = to - from;
    if (width == 0 || length / width < 5) {
        for (size_t k = from; k < to; k++)
            visit(context, k);
        return;
    }
    for (size_t i = 0; i < width; i++)
        visit_extremes(numbers, from + length * i / width, from + length * (i + 1) / width, visit,
                       context);
}
