#include "claims.h"

#include <frob/trace.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static enum verdict worse(enum verdict a, enum verdict b)
{
    return a > b ? a : b;
}

enum verdict verdict_of(const struct frob_value *value, const void *output)
{
    enum verdict worst = VERDICT_NONE;
    if (value->kind == FROB_ARRAY) {
        const struct frob_constructor *elements = &value->constructors[0];
        for (size_t i = 0; i < elements->count; i++)
            worst = worse(worst, verdict_of(elements->fields[i].value, output));
        return worst;
    }
    const uint8_t tag = ((const uint8_t *)output)[value->offset];
    if (!value->is_event)
        return (enum verdict)tag;
    return tag == 0 ? VERDICT_NONE : verdict_of(value->constructors[1].fields[0].value, output);
}

/* ---- NaN */

static bool any_has_nan(const struct frob_constructor *constructor, const void *base)
{
    for (size_t i = 0; i < constructor->count; i++)
        if (claims_has_nan(constructor->fields[i].value, base))
            return true;
    return false;
}

bool claims_has_nan(const struct frob_value *value, const void *base)
{
    const unsigned char *at = (const unsigned char *)base + value->offset;
    double number;
    float single;
    switch (value->kind) {
    case FROB_FLOAT:
    case FROB_ROUNDED: memcpy(&number, at, sizeof number); return isnan(number);
    case FROB_SINGLE: memcpy(&single, at, sizeof single); return isnan(single);
    case FROB_PRODUCT:
    case FROB_ARRAY: return any_has_nan(&value->constructors[0], base);
    case FROB_SUM: return *at < value->count && any_has_nan(&value->constructors[*at], base);
    case FROB_BOOL:
    case FROB_INT:
    case FROB_IMAGE: break;
    }
    return false;
}

/* If memory runs out, the column is not checked. */
static void add_column(void *context, const char *name, const struct frob_value *value)
{
    struct claims *claims = (struct claims *)context;
    struct nan_column *column;
    if (claims->nan_count == claims->nan_room) {
        const size_t room = claims->nan_room == 0 ? 16 : 2 * claims->nan_room;
        column = (struct nan_column *)realloc(claims->nans, room * sizeof *column);
        if (column == NULL)
            return;
        claims->nans = column;
        claims->nan_room = room;
    }
    column = &claims->nans[claims->nan_count];
    memset(column, 0, sizeof *column);
    column->value = value;
    column->name = (char *)malloc(strlen(name) + 1);
    if (column->name == NULL)
        return;
    strcpy(column->name, name);
    claims->nan_count++;
}

static void look_for_nans(struct claims *claims, int64_t time_ns, const void *output)
{
    for (size_t i = 0; i < claims->nan_count && !claims->nan_is_given; i++) {
        struct nan_column *column = &claims->nans[i];
        if (!column->seen && claims_has_nan(column->value, output)) {
            column->seen = true;
            column->first_ns = time_ns;
        }
    }
}

/* Prints at most four columns, and the number of the remaining ones. */
static void print_nans(const struct claims *claims, FILE *file, const char *who)
{
    enum { MOST = 4 };
    size_t seen = 0;
    for (size_t i = 0; i < claims->nan_count; i++) {
        const struct nan_column *column = &claims->nans[i];
        if (column->seen && seen++ < MOST)
            fprintf(file, "%sNaN: %s, first at %.3f s%s\n", who, column->name,
                    (double)column->first_ns * 1e-9,
                    seen == 1 ? "; to find its origin, run `frobc view --why-nan`" : "");
    }
    if (seen > MOST)
        fprintf(file, "%sNaN: in %lu more columns\n", who, (unsigned long)(seen - MOST));
}

/* ---- Assertions */

bool claims_open(struct claims *claims, const struct frob_program *program)
{
    memset(claims, 0, sizeof *claims);
    claims->program = program;
    claims->each = (struct claim_state *)calloc(program->claim_count + 1, sizeof *claims->each);
    if (claims->each == NULL) {
        fprintf(stderr, "error: not enough memory for the program's assertions\n");
        return false;
    }
    for (size_t i = 0; i < program->claim_count; i++)
        claims->each[i].last = VERDICT_NONE;
    if (program->output != NULL) /* NULL if a handwritten table does not describe the output */
        frob_trace_columns(program->output, "out", add_column, claims);
    return true;
}

static void see(struct claims *claims, size_t i, int64_t time_ns, const void *output)
{
    struct claim_state *state = &claims->each[i];
    const struct frob_claim *claim = &claims->program->claims[i];
    const enum verdict verdict = verdict_of(claim->value, output);
    state->fails = false;
    if (verdict == VERDICT_NONE || (claims->is_void && !claim->is_assumption))
        return;
    state->last = verdict;
    state->asked += verdict != VERDICT_NOT_ASKED ? 1 : 0;
    if (verdict != VERDICT_FAILS)
        return;
    state->fails = true;
    if (state->failed++ == 0)
        state->first_ns = time_ns;
    if (claim->is_assumption && !claims->is_void) {
        claims->is_void = true;
        claims->void_ns = time_ns;
    } else if (!claim->is_assumption && claims->violated == NULL) {
        claims->violated = claim;
        claims->violated_ns = time_ns;
    }
}

/* Handles the assumptions first: an assumption that fails now makes the verdicts of assertions
 * at this instant invalid. */
void claims_see(struct claims *claims, int64_t time_ns, const void *output)
{
    const size_t count = claims->program->claim_count;
    look_for_nans(claims, time_ns, output);
    for (size_t i = 0; i < count; i++)
        if (claims->program->claims[i].is_assumption)
            see(claims, i, time_ns, output);
    for (size_t i = 0; i < count; i++)
        if (!claims->program->claims[i].is_assumption)
            see(claims, i, time_ns, output);
}

/* Returns whether the assertion's label is unique. Assertions that share a label are identified by
 * their columns. */
static bool is_alone(const struct frob_program *program, const struct frob_claim *claim)
{
    for (size_t i = 0; i < program->claim_count; i++)
        if (&program->claims[i] != claim && strcmp(program->claims[i].label, claim->label) == 0)
            return false;
    return true;
}

void claims_fate(const struct claims *claims, size_t i, char text[CLAIMS_FATE])
{
    const bool is_assumption = claims->program->claims[i].is_assumption;
    const struct claim_state *state = &claims->each[i];
    if (state->failed > 0)
        snprintf(text, CLAIMS_FATE, "%s, first at %.3f s; in total at %llu %s",
                 is_assumption ? "failed" : "violated", (double)state->first_ns * 1e-9,
                 (unsigned long long)state->failed, state->failed == 1 ? "instant" : "instants");
    else if (claims->is_void && !is_assumption)
        snprintf(text, CLAIMS_FATE, "%s until an assumption failed at %.3f s",
                 state->asked > 0 ? "held" : "not checked", (double)claims->void_ns * 1e-9);
    else
        snprintf(text, CLAIMS_FATE, "%s",
                 state->last == VERDICT_OPEN ? "undecided at the end"
                 : state->asked > 0          ? "held"
                                             : "never checked");
}

void claims_print(const struct claims *claims, FILE *file, const char *who)
{
    const struct frob_program *program = claims->program;
    char fate[CLAIMS_FATE];
    for (size_t i = 0; i < program->claim_count; i++) {
        const struct frob_claim *claim = &program->claims[i];
        fprintf(file, "%s%s \"%s\"", who, claim->is_assumption ? "assume" : "assert", claim->label);
        if (!is_alone(program, claim))
            fprintf(file, " (%s)", claim->column);
        claims_fate(claims, i, fate);
        fprintf(file, ": %s\n", fate);
    }
    print_nans(claims, file, who);
}

void claims_complain(const struct claims *claims)
{
    fprintf(stderr, "error: \"%s\" (%s) was violated at %.3f s\n", claims->violated->label,
            claims->violated->place, (double)claims->violated_ns * 1e-9);
}

void claims_close(struct claims *claims)
{
    free(claims->each);
    for (size_t i = 0; i < claims->nan_count; i++)
        free(claims->nans[i].name);
    free(claims->nans);
}
