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

/* Allocates space for the values at all instants. */
static bool has_room(const struct series *series, struct kept_series *place)
{
    const size_t count = series->replay->recording->count;
    double *numbers;
    if (count <= place->room && place->numbers != NULL)
        return true;
    numbers = (double *)realloc(place->numbers, (count + count / 2 + 64) * sizeof *numbers);
    if (numbers == NULL) {
        place->signal = NULL;
        return false;
    }
    place->numbers = numbers;
    place->room = count + count / 2 + 64;
    return true;
}

/* Returns a cache entry for the values of another signal: a free one or, if there is none, the
 * least recently used one. Returns NULL if memory runs out. */
static struct kept_series *place_for(struct series *series, const struct signal *signal)
{
    struct kept_series *place = &series->kept[0];
    for (size_t i = 1; i < SERIES_KEPT; i++)
        if (series->kept[i].used < place->used)
            place = &series->kept[i];
    place->signal = signal;
    place->used = series->uses;
    place->count = 0;
    return has_room(series, place) ? place : NULL;
}

static struct kept_series *find(struct series *series, const struct signal *signal)
{
    for (size_t i = 0; i < SERIES_KEPT; i++)
        if (series->kept[i].signal == signal)
            return &series->kept[i];
    return NULL;
}

/* Returns whether a signal is in the recording, so that the program need not be run for it.
 * Recorded outputs qualify only as long as the program's outputs match them. */
static bool is_recorded(const struct replay *replay, const struct signal *signal)
{
    const size_t number = (size_t)(signal - replay->signals->all);
    if (signal->side == INPUT || !replay->runs)
        return true;
    return signal->side == OUTPUT && replay->recording->program == replay->signals->program &&
           replay->recording->recorded[number] && !replay->diverged;
}

static void read_out(struct replay *replay, struct kept_series *kept)
{
    const struct recording *recording = replay->recording;
    for (; kept->count < recording->count; kept->count++) {
        const size_t k = kept->count;
        struct moment moment = { recording_input(recording, k), recording_output(recording, k),
                                 NULL };
        kept->numbers[k] = signal_number(replay->signals, kept->signal, &moment);
    }
}

/* Computes the values of several signals in a single pass over the recording. Signals for which
 * more values are already known wait for the others. */
static void run_over(struct replay *replay, struct kept_series *const *wanted, size_t count)
{
    for (size_t k = wanted[0]->count; k < replay->recording->count; k++) {
        struct moment moment = replay_at(replay, k);
        for (size_t i = 0; i < count; i++)
            if (wanted[i]->count == k)
                wanted[i]->numbers[wanted[i]->count++] =
                    signal_number(replay->signals, wanted[i]->signal, &moment);
    }
}

enum { TOGETHER = SERIES_KEPT / 2 };

/* When a signal is requested for the first time, adds all modes, because a page requests them
 * together. */
static size_t add_modes(struct series *series, struct kept_series **wanted, size_t count)
{
    const struct signals *signals = series->replay->signals;
    for (size_t i = 0; i < signals->count && count < TOGETHER; i++) {
        const struct signal *other = &signals->all[i];
        if (!signal_is_mode(other) || find(series, other) != NULL)
            continue;
        wanted[count] = place_for(series, other);
        if (wanted[count] == NULL)
            break;
        count++;
    }
    return count;
}

/* Adds the other signals that have at least as many values as the first one, because the page of a
 * live run requests all of them again. */
static size_t add_others(struct series *series, struct kept_series **wanted, size_t count)
{
    for (size_t i = 0; i < SERIES_KEPT && count < TOGETHER; i++) {
        struct kept_series *other = &series->kept[i];
        if (other != wanted[0] && other->signal != NULL && other->count > 0 &&
            other->count >= wanted[0]->count && !is_recorded(series->replay, other->signal) &&
            has_room(series, other))
            wanted[count++] = other;
    }
    return count;
}

/* Computes values for which the program must be run. */
static void compute(struct series *series, struct kept_series *kept)
{
    struct kept_series *wanted[TOGETHER] = { kept };
    size_t count = 1;
    if (kept->count == 0)
        count = add_modes(series, wanted, count);
    else
        count = add_others(series, wanted, count);
    run_over(series->replay, wanted, count);
}

const double *series_of(struct series *series, const struct signal *signal)
{
    struct kept_series *kept = find(series, signal);
    series->uses++;
    if (kept == NULL)
        kept = place_for(series, signal);
    else if (!has_room(series, kept))
        kept = NULL;
    if (kept == NULL)
        return NULL;
    kept->used = series->uses;
    if (is_recorded(series->replay, signal))
        read_out(series->replay, kept);
    else
        compute(series, kept);
    return kept->numbers;
}

void series_forget(struct series *series)
{
    struct replay *replay = series->replay;
    series_end(series);
    series_start(series, replay);
}

/* Visits, in order, the first and last instants of one column of the plot, and those with its least
 * and greatest values. The column has at least five instants. */
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
