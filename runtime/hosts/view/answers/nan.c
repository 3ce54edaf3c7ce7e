#include "nan.h"

#include "../../common/claims.h"

#include <stdio.h>
#include <string.h>

/* Maximum number of steps back, through signals and instants. More distant origins are not
 * found. */
#define FARTHEST 100000

/* Maximum number of sources of one value to examine. */
#define MOST 256

static bool is_nan(struct view *view, const struct signal *signal, size_t k)
{
    const struct moment moment = replay_at(&view->replay, k);
    const void *base = signal->side == INPUT ? moment.input : moment.output;
    return signal->side != MODE && (signal->side != PROBE || moment.state != NULL) &&
           claims_has_nan(signal->value, base);
}

/* Returns the instant from which a signal has been NaN without interruption. */
static size_t since(struct view *view, const struct signal *signal, size_t k)
{
    while (k > 0 && is_nan(view, signal, k - 1))
        k--;
    return k;
}

/* Goes back from a value that is NaN, or was computed from NaN, to a source that is NaN, and to the
 * instant at which that source became NaN. Returns false if no source is NaN. */
static bool step_back(struct view *view, struct why_source *at)
{
    struct why_source found[MOST];
    const size_t count = why_sources(&view->replay, view->origins, at->signal, at->k, found, MOST);
    for (size_t i = 0; i < count; i++) {
        const bool is_itself = found[i].signal == at->signal && found[i].k == at->k;
        if (!is_itself && is_nan(view, found[i].signal, found[i].k)) {
            at->signal = found[i].signal;
            at->k = since(view, found[i].signal, found[i].k);
            return true;
        }
    }
    return false;
}

static const char *own_name(const struct signal *signal)
{
    return strncmp(signal->name, "probe.", 6) == 0 ? signal->name + 6 : signal->name;
}

static double seconds(const struct view *view, size_t k)
{
    return (double)(view->recording.times[k] + view->recording.origin) / 1e9;
}

/* Completes the line that begins with `named`: prints the origin of the NaN at `at`. */
static void print_origin(struct view *view, const struct signal *named, struct why_source at)
{
    const struct frob_origin *origin = why_origin(view->origins, at.signal);
    const size_t start = at.k;
    for (size_t steps = 0; steps < FARTHEST && step_back(view, &at); steps++)
        origin = why_origin(view->origins, at.signal);
    if (at.signal->side == INPUT) {
        printf(", from the input %s", own_name(at.signal));
    } else {
        if (at.signal != named)
            printf(", from %s", own_name(at.signal));
        if (origin != NULL && origin->file != NULL && origin->file[0] != '\0')
            printf("%s at %s:%u", at.signal == named ? ", from its equation" : "", origin->file,
                   origin->line);
    }
    if (at.k != start)
        printf(", NaN since %.3f s", seconds(view, at.k));
    printf("\n");
}

/* Returns the first instant at which an assertion fails, or the number of instants if there is
 * none. */
static size_t first_failure(struct view *view, const struct frob_claim *claim)
{
    size_t k = 0;
    while (k < view->recording.count) {
        const struct moment moment = replay_at(&view->replay, k);
        if (moment.state != NULL && verdict_of(claim->value, moment.output) == VERDICT_FAILS)
            break;
        k++;
    }
    return k;
}

static void print_claims(struct view *view)
{
    for (size_t i = 0; i < view->program->claim_count; i++) {
        const struct frob_claim *claim = &view->program->claims[i];
        const size_t k = first_failure(view, claim);
        for (size_t j = 0; k < view->recording.count && j < view->signals.count; j++) {
            const struct signal *signal = &view->signals.all[j];
            struct why_source at = { signal, k };
            if (signal->side != PROBE || strcmp(own_name(signal), claim->column) != 0 ||
                !step_back(view, &at))
                continue;
            printf("NaN: %s \"%s\", violated at %.3f s", claim->is_assumption ? "assume" : "assert",
                   claim->label, seconds(view, k));
            print_origin(view, signal, at);
        }
    }
}

bool nan_print(struct view *view)
{
    size_t count;
    while (recording_read_on(&view->recording))
        continue;
    while (view->replay.runs && !replay_is_whole(&view->replay))
        replay_advance(&view->replay);
    count = view->recording.count;
    if (!view->replay.runs) {
        fprintf(stderr, "error: the program cannot be run on %s\n", view->recording.name);
        return false;
    }
    for (size_t i = 0; i < view->signals.count; i++) {
        const struct signal *signal = &view->signals.all[i];
        size_t k = 0;
        if (signal->side != OUTPUT)
            continue;
        while (k < count && !is_nan(view, signal, k))
            k++;
        if (k == count)
            continue;
        printf("NaN: %s, first at %.3f s", signal->name, seconds(view, k));
        print_origin(view, signal, (struct why_source){ signal, k });
    }
    print_claims(view);
    return true;
}
