#include "stamps.h"

/* A different clock is accepted after its messages have been arriving for this long. Until this
 * long after the first message, timestamps that are ahead are accepted, because the first message
 * may have been delayed. */
#define DOUBT_NS INT64_C(1000000000)

/* Two clocks run at different speeds (clock drift), so the smallest difference may grow by the
 * elapsed time divided by this number. */
enum { DRIFT = 2000 };

static int64_t apart(int64_t a, int64_t b)
{
    return a > b ? a - b : b - a;
}

static void accept(struct stamps *s, int64_t stamp_ns, int64_t arrived_ns)
{
    s->newest_ns = stamp_ns;
    s->previous_ns = arrived_ns;
    s->doubted = false;
}

/* Rejects a message from a different clock or, after DOUBT_NS, accepts that clock. */
static enum stamps_verdict doubt(struct stamps *s, enum stamps_verdict verdict, int64_t stamp_ns,
                                 int64_t arrived_ns, int64_t patience_ns)
{
    const int64_t difference = arrived_ns - stamp_ns;
    if (!s->doubted || apart(difference, s->other_ns) > patience_ns) {
        s->doubted = true;
        s->doubted_ns = arrived_ns;
    }
    s->other_ns = difference;
    if (arrived_ns - s->doubted_ns < DOUBT_NS)
        return verdict;
    s->shortest_ns = difference;
    accept(s, stamp_ns, arrived_ns);
    return STAMPS_RESET;
}

enum stamps_verdict stamps_judge(struct stamps *s, int64_t stamp_ns, int64_t arrived_ns,
                                 int64_t patience_ns, int64_t *by_ns)
{
    const int64_t difference = arrived_ns - stamp_ns;
    *by_ns = 0;
    if (stamp_ns == 0)
        return STAMPS_GOOD;
    if (!s->started) {
        s->started = true;
        s->first_ns = arrived_ns;
        s->shortest_ns = difference;
        accept(s, stamp_ns, arrived_ns);
        return STAMPS_GOOD;
    }
    if (stamp_ns < s->newest_ns) {
        *by_ns = s->newest_ns - stamp_ns;
        return doubt(s, STAMPS_BACK, stamp_ns, arrived_ns, patience_ns);
    }
    s->shortest_ns += (arrived_ns - s->previous_ns) / DRIFT;
    s->previous_ns = arrived_ns;
    *by_ns = apart(difference, s->shortest_ns);
    if (difference < s->shortest_ns && *by_ns > patience_ns && arrived_ns - s->first_ns >= DOUBT_NS)
        return doubt(s, STAMPS_AHEAD, stamp_ns, arrived_ns, patience_ns);
    if (difference < s->shortest_ns) {
        s->shortest_ns = difference;
        *by_ns = 0;
    }
    if (*by_ns > patience_ns)
        return STAMPS_OLD;
    accept(s, stamp_ns, arrived_ns);
    return STAMPS_GOOD;
}
