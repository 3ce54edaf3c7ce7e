#include "why.h"

#include <stdlib.h>
#include <string.h>

/* Maximum number of instants to search back for the start of a value. */
#define FARTHEST 16384

/* Maximum number of signals in one source, such as an array. */
#define MOST 64

/* ---- Instants */

/* Number of instants in the cache. An answer reads a few instants repeatedly. */
#define KEPT 8

struct why {
    struct replay *replay;
    const struct frob_origin *origins;
    struct look {
        size_t k;
        struct moment moment;
        unsigned char *bytes; /* copies of its output and state */
    } looks[KEPT];
    size_t count, oldest;
    struct buffer *answer;
    struct why_source *found; /* if not NULL, receives the sources instead of `answer` */
    size_t found_count, most; /* `most` is the size of `found` */
};

/* Returns an instant, which stays valid until KEPT other instants have been read. */
static struct moment look_at(struct why *why, size_t k)
{
    const struct frob_program *program = why->replay->signals->program;
    struct look *look;
    struct moment moment;
    for (size_t i = 0; i < why->count; i++)
        if (why->looks[i].k == k)
            return why->looks[i].moment;
    moment = replay_at(why->replay, k);
    look = &why->looks[why->count < KEPT ? why->count : why->oldest++ % KEPT];
    if (why->count < KEPT)
        look->bytes = (unsigned char *)malloc(program->output_size + program->state_size + 1);
    if (look->bytes == NULL) {
        why->answer->failed = true;
        return moment;
    }
    why->count += why->count < KEPT ? 1 : 0;
    look->k = k;
    look->moment = moment;
    if (moment.state != NULL) {
        memcpy(look->bytes, moment.output, program->output_size);
        memcpy(look->bytes + program->output_size, moment.state, program->state_size);
        look->moment.output = look->bytes;
        look->moment.state = look->bytes + program->output_size;
    }
    return look->moment;
}

static bool is_there(struct why *why, const struct signal *signal, size_t k)
{
    const struct moment moment = look_at(why, k);
    const void *base = signal->side == INPUT ? moment.input : moment.output;
    if (signal->side == PROBE && moment.state == NULL)
        return false;
    return signal->side == MODE || signal->shown == signal->value ||
           ((const unsigned char *)base)[signal->value->offset] != 0;
}

/* Returns whether the signal function that contains a signal runs at an instant. If the signal is
 * an event, checks another signal of the same signal function. */
static bool runs(struct why *why, const struct signal *signal, size_t k)
{
    const struct signals *signals = why->replay->signals;
    const bool is_event = signal->shown == signal->value && signal->column != NULL &&
                          signal->side == PROBE && signal->value->is_event;
    if (!is_event)
        return is_there(why, signal, k);
    for (size_t i = 0; i < signals->count; i++) {
        const struct signal *other = &signals->all[i];
        if (other->side == PROBE && other->column != NULL && other->shown != other->value &&
            strcmp(other->column->instance, signal->column->instance) == 0)
            return is_there(why, other, k);
    }
    return true;
}

/* Returns the mode in a machine's column; -1 if the machine does not run. */
static int mode_at(struct why *why, const struct signal *machine, size_t k)
{
    const struct moment moment = look_at(why, k);
    const unsigned char *output = (const unsigned char *)moment.output;
    return is_there(why, machine, k) ? output[machine->shown->offset] : -1;
}

static bool same(const struct buffer *a, const struct buffer *b)
{
    return strcmp(a->data == NULL ? "" : a->data, b->data == NULL ? "" : b->data) == 0;
}

/* Returns the last instant in a block at which a signal's value differs from its value at the
 * previous instant; the block's first instant if the signal is constant. Stores its cells at the
 * block's first and last instants in `first` and `last`. */
static size_t last_change(struct why *why, const struct signal *signal, size_t from, size_t to,
                          struct buffer *first, struct buffer *last)
{
    size_t changed = from;
    buffer_clear(first);
    for (size_t i = from; i <= to; i++) {
        struct moment moment = replay_at(why->replay, i);
        struct buffer now = { 0 };
        signal_write(why->replay->signals, signal, &moment, &now);
        if (i == from)
            buffer_text(first, now.length > 0 ? now.data : "");
        else if (!same(last, &now))
            changed = i;
        buffer_free(last);
        *last = now;
    }
    return changed;
}

/* Returns the instant at which a signal took on the value that it has at `k`. If that is too long
 * ago, returns a later instant and sets *is_longer. */
static size_t since(struct why *why, const struct signal *signal, size_t k, bool *is_longer)
{
    const size_t end = k > FARTHEST ? k - FARTHEST : 0;
    struct buffer first = { 0 }, last = { 0 }, after = { 0 };
    size_t from = k / REPLAY_EVERY * REPLAY_EVERY, result;
    *is_longer = false;
    result = last_change(why, signal, from, k, &after, &last);
    while (result == from && from > 0 && !*is_longer) {
        const size_t before = from - REPLAY_EVERY;
        const size_t changed = last_change(why, signal, before, from - 1, &first, &last);
        struct buffer swap = after;
        if (!same(&last, &after))
            break;
        result = changed;
        from = before;
        *is_longer = changed == before && before > 0 && before <= end;
        after = first;
        first = swap;
    }
    buffer_free(&first);
    buffer_free(&last);
    buffer_free(&after);
    return result;
}

/* ---- Sources */

/* Returns whether `column` is the signal's column, or that of an array or record that contains
 * it. */
static bool is_of(const struct signal *signal, const char *column)
{
    const size_t length = strlen(column);
    const char end = strncmp(signal->name, column, length) == 0 ? signal->name[length] : ' ';
    return end == '\0' || end == '.' || end == '[';
}

static void add_place(struct buffer *answer, const char *file, unsigned line, unsigned last)
{
    buffer_text(answer, ",\"file\":");
    buffer_string(answer, file);
    buffer_format(answer, ",\"line\":%u,\"last\":%u", line, last);
}

static void add_instant(struct why *why, size_t k)
{
    buffer_format(why->answer, "\"k\":%lu,\"time\":", (unsigned long)k);
    buffer_number(why->answer, (double)why->replay->recording->times[k] / 1e9);
}

static void add_source(struct why *why, const struct signal *signal, size_t k, const char **comma)
{
    const struct signals *signals = why->replay->signals;
    const struct moment moment = look_at(why, k);
    struct buffer cell = { 0 };
    if (why->found != NULL) {
        if (why->found_count < why->most)
            why->found[why->found_count++] = (struct why_source){ signal, k };
        return;
    }
    signal_write(signals, signal, &moment, &cell);
    buffer_format(why->answer, "%s{\"signal\":%lu,", *comma,
                  (unsigned long)(signal - signals->all));
    add_instant(why, k);
    buffer_text(why->answer, ",\"cell\":");
    buffer_string(why->answer, cell.length > 0 ? cell.data : "");
    buffer_text(why->answer, "}");
    buffer_free(&cell);
    *comma = ",";
}

/* ---- Switches */

const struct frob_origin *why_origin(const struct frob_origin *origins, const struct signal *signal)
{
    const struct frob_origin *found = NULL;
    size_t longest = 0;
    for (const struct frob_origin *o = origins; o != NULL && o->column != NULL; o++) {
        if (is_of(signal, o->column) && strlen(o->column) > longest) {
            longest = strlen(o->column);
            found = o;
        }
    }
    return found;
}

/* Maximum number of transitions in one instant that an answer lists. */
#define LONGEST 16

/* Finds how a machine changed from one mode to another in an instant: by one transition, or by
 * several transitions through modes that ended as soon as they began. Stores the shortest path and
 * returns its length; 0 if it is unknown. */
static size_t way(const struct frob_transition *transitions, int from, int to,
                  const struct frob_transition *result[LONGEST])
{
    enum { MODES = 256 };
    const struct frob_transition *by[MODES] = { NULL };
    int queue[MODES];
    size_t count = 0, length = 0, head = 0;
    if (from < 0 || from >= MODES || to >= MODES)
        return 0;
    for (bool is_first = true; by[to] == NULL && (is_first || head < count); is_first = false) {
        const int at = is_first ? from : queue[head++];
        for (const struct frob_transition *t = transitions; t->label != NULL; t++) {
            const bool leaves = t->from == at || (is_first && t->from == FROB_ANY);
            if (!leaves || (!is_first && !t->at_once) || t->target >= MODES ||
                by[t->target] != NULL)
                continue;
            by[t->target] = t;
            queue[count++] = t->target;
        }
    }
    /* Follows the path backwards. The path may end in the mode in which it started. */
    for (int at = to; by[at] != NULL && length < LONGEST; at = by[at]->from) {
        result[length++] = by[at];
        if (by[at]->from == from || by[at]->from == FROB_ANY)
            break;
    }
    for (size_t i = 0; i < length / 2; i++) {
        const struct frob_transition *t = result[i];
        result[i] = result[length - 1 - i];
        result[length - 1 - i] = t;
    }
    return length;
}

/* The instant at which a machine's current mode began, and the transitions that led to it. `count`
 * is 0 if the machine itself began, or if the transitions are unknown. */
struct entry {
    size_t k;
    bool is_known;
    int before;
    const struct frob_transition *way[LONGEST];
    size_t count;
};

static struct entry entry_of(struct why *why, const struct signal *machine, size_t k)
{
    const struct frob_origin *origin = why_origin(why->origins, machine);
    struct entry entry = { 0 };
    bool is_longer;
    entry.k = since(why, machine, k, &is_longer);
    entry.is_known = !is_longer;
    entry.before = entry.k == 0 || is_longer ? -1 : mode_at(why, machine, entry.k - 1);
    if (origin != NULL && origin->transitions != NULL && entry.is_known && entry.before >= 0)
        entry.count =
            way(origin->transitions, entry.before, mode_at(why, machine, entry.k), entry.way);
    return entry;
}

/* Checks a source that is read when a mode begins: returns whether the source belongs to a mode
 * that was left at that instant. */
static bool is_of_entry(const struct entry *entry, const struct frob_source *source)
{
    if (source->mode == FROB_ANY || source->mode == entry->before)
        return true;
    if (entry->before < 0)
        return source->mode == FROB_BEFORE;
    for (size_t i = 1; i < entry->count; i++)
        if (entry->way[i]->from == source->mode)
            return true;
    return false;
}

/* The kind of value: a signal at an instant, or an event that ended a mode. At the instant of such
 * an event, the signals of the old mode are no longer visible. */
enum asked { VALUE, EVENT };

/* Computes the instant at which a source was read. Returns false if the source does not apply. */
static bool instant_of(struct why *why, const struct signal *of, const struct frob_source *source,
                       enum asked asked, size_t k, size_t *at)
{
    const struct signal *machine = signals_find(why->replay->signals, source->machine);
    *at = k;
    if (source->back == FROB_ENTRY && machine != NULL) {
        const struct entry entry = entry_of(why, machine, k);
        *at = entry.k;
        return entry.is_known && is_of_entry(&entry, source);
    }
    if (source->back == FROB_ENTRY)
        return true;
    if (source->back == FROB_FIRST)
        return k == 0 || (asked == VALUE && of->shown != of->value && !is_there(why, of, k - 1));
    if (k < (size_t)source->back)
        return false;
    *at = k - (size_t)source->back;
    if (machine == NULL)
        return true;
    if (asked == EVENT && *at > 0 && mode_at(why, machine, *at) < 0)
        return mode_at(why, machine, *at - 1) == source->mode;
    return mode_at(why, machine, *at) == source->mode;
}

static void add_sources(struct why *why, const struct signal *of, const struct frob_source *sources,
                        enum asked asked, size_t k)
{
    const struct signals *signals = why->replay->signals;
    const char *comma = "";
    buffer_text(why->answer, ",\"sources\":[");
    for (; sources != NULL && sources->column != NULL; sources++) {
        size_t at, count = 0;
        if (!instant_of(why, of, sources, asked, k, &at))
            continue;
        for (size_t i = 0; i < signals->count && count < MOST; i++) {
            const struct signal *signal = &signals->all[i];
            if (!is_of(signal, sources->column))
                continue;
            count++;
            /* If its mode has ended, the signal was last visible one instant earlier. */
            if (runs(why, signal, at))
                add_source(why, signal, at, &comma);
            else if ((asked == EVENT || sources->back == FROB_ENTRY) && at > 0 &&
                     runs(why, signal, at - 1))
                add_source(why, signal, at - 1, &comma);
        }
    }
    buffer_text(why->answer, "]");
}

static void add_switches(struct why *why, const struct signal *signal, size_t k)
{
    const struct entry entry = entry_of(why, signal, k);
    buffer_text(why->answer, ",\"switches\":[");
    for (size_t i = 0; i < entry.count; i++) {
        const struct frob_transition *t = entry.way[i];
        const size_t at = t->delayed ? entry.k - 1 : entry.k;
        const int from = t->from == FROB_ANY ? entry.before : t->from;
        buffer_text(why->answer, i > 0 ? ",{\"from\":" : "{\"from\":");
        buffer_string(why->answer, signal->shown->constructors[from].name);
        buffer_text(why->answer, ",\"to\":");
        buffer_string(why->answer, signal->shown->constructors[t->target].name);
        buffer_text(why->answer, ",\"label\":");
        buffer_string(why->answer, t->label);
        buffer_text(why->answer, ",");
        add_instant(why, at);
        add_place(why->answer, t->file, t->line, t->last);
        add_sources(why, signal, t->sources, t->delayed ? VALUE : EVENT, at);
        buffer_text(why->answer, "}");
    }
    buffer_text(why->answer, "]");
}

void why_answer(struct replay *replay, const struct frob_origin *origins,
                const struct signal *signal, size_t k, struct buffer *answer)
{
    struct why why = { .replay = replay, .origins = origins, .answer = answer };
    const struct frob_origin *origin = replay->runs ? why_origin(origins, signal) : NULL;
    bool is_longer;
    const size_t first = since(&why, signal, k, &is_longer);
    buffer_text(answer, ",\"since\":{");
    add_instant(&why, first);
    buffer_format(answer, ",\"longer\":%s}", is_longer ? "true" : "false");
    if (origin == NULL)
        add_place(answer, "", 0, 0);
    else
        add_place(answer, origin->file, origin->line, origin->last);
    add_sources(&why, signal, origin == NULL ? NULL : origin->sources, VALUE, k);
    if (origin != NULL && origin->transitions != NULL)
        add_switches(&why, signal, k);
    for (size_t i = 0; i < why.count; i++)
        free(why.looks[i].bytes);
}

size_t why_sources(struct replay *replay, const struct frob_origin *origins,
                   const struct signal *signal, size_t k, struct why_source *found, size_t most)
{
    struct buffer unused = { 0 };
    struct why why = {
        .replay = replay, .origins = origins, .answer = &unused, .found = found, .most = most
    };
    const struct frob_origin *origin = replay->runs ? why_origin(origins, signal) : NULL;
    if (origin != NULL)
        add_sources(&why, signal, origin->sources, VALUE, k);
    for (size_t i = 0; i < why.count; i++)
        free(why.looks[i].bytes);
    buffer_free(&unused);
    return why.found_count;
}
