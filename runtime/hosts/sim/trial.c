#include "trial.h"

#include <frob/cell.h>
#include <frob/trace.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The judge's input columns for the true state, in the order of the argument `truths` of `fill`. */
enum { TRUTHS = TRIAL_TRUTHS };

static const char *const truth_names[TRUTHS] = {
    "in.pose.position.x", "in.pose.position.y", "in.pose.heading",  "in.clearance",
    "in.touches",         "in.driven",          "in.odometryError", "in.ended",
};

/* If the column is one of `truth_names`, stores its position in the judge's input. */
static void find(void *context, const char *name, const struct frob_value *value)
{
    struct trial *trial = (struct trial *)context;
    for (size_t i = 0; i < TRUTHS; i++)
        if (strcmp(truth_names[i], name) == 0)
            trial->truths[i] = value;
}

static void fill(const struct trial *trial, const double *truths)
{
    for (size_t i = 0; i < TRUTHS; i++) {
        const struct frob_value *value = trial->truths[i];
        unsigned char *place;
        if (value == NULL)
            continue;
        place = (unsigned char *)trial->input + value->offset;
        if (value->kind == FROB_BOOL)
            *(bool *)place = truths[i] != 0.0;
        else if (value->kind == FROB_SINGLE)
            *(float *)(void *)place = (float)truths[i];
        else
            *(double *)(void *)place = truths[i];
    }
}

bool trial_open(struct trial *trial, const struct frob_program *judge)
{
    memset(trial, 0, sizeof *trial);
    trial->judge = judge;
    trial->params = judge->default_params;
    frob_trace_columns(judge->input, "in", find, trial);
    trial->state = calloc(1, trial->judge->state_size + 1);
    trial->input = calloc(1, trial->judge->input_size + 1);
    trial->output = calloc(1, trial->judge->output_size + 1);
    if (trial->state != NULL && trial->input != NULL && trial->output != NULL)
        return true;
    fprintf(stderr, "error: not enough memory for the judge's state\n");
    return false;
}

void trial_close(struct trial *trial)
{
    free(trial->state);
    free(trial->input);
    free(trial->output);
}

struct end {
    const char *fate, *label;
    int64_t time_ns;
};

static bool ends(struct end *end, const char *fate, const char *label, int64_t time_ns)
{
    end->fate = fate;
    end->label = label;
    end->time_ns = time_ns;
    return true;
}

static const char *failed_assumption(const struct claims *claims)
{
    for (size_t i = 0; i < claims->program->claim_count; i++)
        if (claims->program->claims[i].is_assumption && claims->each[i].failed > 0)
            return claims->program->claims[i].label;
    return NULL;
}

static bool was_asked(const struct claims *claims)
{
    for (size_t i = 0; i < claims->program->claim_count; i++)
        if (claims->each[i].asked > 0)
            return true;
    return false;
}

/* Returns whether something has failed, in which case this is the last instant. */
static bool has_failed(const struct controllers *controllers, const struct claims *judged,
                       enum verdict said, int64_t now_ns, struct end *end)
{
    const struct claims *violated;
    const char *assumption = failed_assumption(judged);
    for (size_t k = 0; assumption == NULL && k < controllers->count; k++)
        assumption = failed_assumption(&controllers->each[k].claims);
    if (assumption != NULL)
        return ends(end, "void", assumption, now_ns);
    violated = controllers_violated(controllers);
    if (violated == NULL && judged->violated != NULL)
        violated = judged;
    if (violated != NULL)
        return ends(end, "violated", violated->violated->label, now_ns);
    return said == VERDICT_FAILS && ends(end, "violated", "judge", now_ns);
}

static void see_truth(const struct controllers *controllers, double *truths)
{
    const struct frob_sim_place place = frob_sim_place_robot(controllers->sim, 0);
    const struct frob_sim_summary summary = frob_sim_summarize_robot(controllers->sim, 0);
    const double all[TRUTHS] = {
        place.x_m,
        place.y_m,
        place.heading_rad,
        frob_sim_clearance_robot(controllers->sim, 0),
        place.touches ? 1.0 : 0.0,
        summary.distance_m,
        summary.odometry_error_m,
        controllers->each[0].ended ? 1.0 : 0.0,
    };
    memcpy(truths, all, sizeof all);
}

static bool run(struct trial *trial, const struct options *options, struct controllers *controllers,
                struct claims *judged, double *truths, struct end *end)
{
    struct touches touches;
    const int64_t end_ns = (int64_t)llround(options->duration_s * 1e9);
    enum verdict said = VERDICT_NOT_ASKED;
    bool asked = false, ok = touches_start(&touches, controllers->program);
    int64_t before_ns = 0;
    trial->judge->reset(trial->state, trial->params);
    for (int64_t k = 0; ok; k++) {
        const int64_t now_ns = (int64_t)llround((double)k * 1e9 / options->rate_hz);
        if (now_ns > end_ns)
            break;
        frob_sim_advance(controllers->sim, now_ns);
        ok = controllers_step(controllers, now_ns, &touches);
        see_truth(controllers, truths);
        fill(trial, truths);
        trial->judge->step(trial->state, trial->params, now_ns - before_ns,
                           (double)(now_ns - before_ns) / 1e9, trial->input, trial->output);
        claims_see(judged, now_ns, trial->output);
        said = verdict_of(trial->judge->output, trial->output);
        asked = asked || said != VERDICT_NOT_ASKED;
        if (has_failed(controllers, judged, said, now_ns, end))
            break;
        before_ns = now_ns;
    }
    touches_end(&touches);
    if (end->fate != NULL)
        return ok;
    for (size_t k = 0; k < controllers->count; k++)
        asked = asked || was_asked(&controllers->each[k].claims);
    asked = asked || was_asked(judged);
    if (said == VERDICT_OPEN)
        ends(end, "undecided", "judge", before_ns);
    else
        ends(end, asked ? "held" : "unasked", "", before_ns);
    return ok;
}

/* Prints the number of collisions of the first robot, and for the first collision the time, place,
 * clearance and object, each after a tab. The cells are empty if there was no collision. */
static void print_collisions(const struct frob_sim *sim, FILE *file)
{
    struct frob_sim_collision first;
    fprintf(file, "\t%d", frob_sim_summarize_robot(sim, 0).collisions);
    if (frob_sim_collision_robot(sim, 0, 0, &first))
        fprintf(file, "\t%.9f\t%.9g\t%.9g\t%.9g\t%s", first.time_s, first.x_m, first.y_m,
                first.clearance_m, first.with);
    else
        fputs("\t\t\t\t\t", file);
}

/* Prints the measurements of the judge: a tab and `name=value` for each. */
static bool print_measures(const struct trial *trial, FILE *file)
{
    const struct frob_value *probes = trial->judge->probes;
    for (size_t i = 0; probes != NULL && i < probes->constructors[0].count; i++) {
        const struct frob_field *field = &probes->constructors[0].fields[i];
        const size_t room = frob_cell_room(field->value) + 1;
        char *buffer = (char *)malloc(room);
        struct frob_text text;
        if (buffer == NULL) {
            fprintf(stderr, "error: not enough memory for the measurements\n");
            return false;
        }
        text = frob_text_in(buffer, room);
        frob_cell_write(&text, field->value, trial->output);
        fprintf(file, "\t%s=%s", field->name, text.data);
        free(buffer);
    }
    return true;
}

bool trial_run(struct trial *trial, const struct options *options, const struct params *params,
               struct frob_sim *sim, FILE *file)
{
    char message[1024];
    struct controllers controllers;
    struct claims judged;
    double truths[TRUTHS] = { 0.0 };
    struct end end = { NULL, "", 0 };
    bool ok = controllers_open(&controllers, params, sim, options->record);
    ok = claims_open(&judged, trial->judge) && ok;
    ok = ok && run(trial, options, &controllers, &judged, truths, &end);
    if (ok && options->picture != NULL &&
        !frob_sim_picture(sim, options->picture, message, sizeof message)) {
        fprintf(stderr, "error: %s\n", message);
        ok = false;
    }
    if (ok) {
        fprintf(file, "%llu\t%s\t%.9f\t%s", (unsigned long long)options->seed, end.fate,
                (double)end.time_ns * 1e-9, end.label);
        for (size_t i = 0; i + 1 < TRUTHS; i++)
            fprintf(file, "\t%.9g", truths[i]);
        print_collisions(sim, file);
        ok = print_measures(trial, file);
        putc('\n', file);
        fflush(file); /* so that frobc can tell in which run a crash occurred */
    }
    claims_close(&judged);
    return controllers_close(&controllers) && ok;
}
