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

static void compute(struct replay *replay, const struct signal *signal, double *numbers)
{
    const struct recording *recording = replay->recording;
    for (size_t k = 0; k < recording->count; k++) {
        struct moment moment = { recording_input(recording, k), NULL, NULL };
        if (signal->side != INPUT)
            moment = replay_at(replay, k);
        numbers[k] = signal_number(replay->signals, signal, &moment);
    }
}

const double *series_of(struct series *series, const struct signal *signal)
{
    struct kept_series *place = &series->kept[0];
    series->uses++;
    for (size_t i = 0; i < SERIES_KEPT; i++) {
        struct kept_series *kept = &series->kept[i];
        if (kept->numbers != NULL && kept->signal == signal) {
            kept->used = series->uses;
            return kept->numbers;
        }
        if (kept->used < place->used)
            place = kept;
    }
    if (place->numbers == NULL)
        place->numbers =
            (double *)malloc(series->replay->recording->count * sizeof *place->numbers);
    if (place->numbers == NULL)
        return NULL;
    place->signal = signal;
    place->used = series->uses;
    compute(series->replay, signal, place->numbers);
    return place->numbers;
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
