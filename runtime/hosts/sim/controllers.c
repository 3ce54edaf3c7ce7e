#include "controllers.h"

#include <frob/camera.h>
#include <frob/console.h>
#include <frob/result.h>
#include <frob/tags.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Returns the name of a robot's recording: LOG.csv for a single robot, LOG-3.csv (or LOG-3.csv.gz)
 * for the third of several. NULL if memory runs out. */
static char *name_of_record(const char *name, size_t robot, size_t count)
{
    const char *slash = strrchr(name, '/');
    const size_t room = strlen(name) + 32, begin = slash == NULL ? 0 : (size_t)(slash - name) + 1;
    size_t stem = packed_stem(name);
    char *result = (char *)malloc(room);
    for (size_t dot = stem; dot > begin + 1; dot--)
        if (name[dot - 1] == '.') {
            stem = dot - 1;
            break;
        }
    if (result != NULL && count == 1)
        snprintf(result, room, "%s", name);
    else if (result != NULL)
        snprintf(result, room, "%.*s-%zu%s", (int)stem, name, robot + 1, name + stem);
    return result;
}

static bool open_one(struct controllers *c, size_t robot, const char *record)
{
    const struct frob_program *program = c->program;
    struct controller *one = &c->each[robot];
    one->record.file.file = -1;
    one->state = calloc(1, program->state_size + 1);
    one->input = calloc(1, program->input_size);
    one->output = calloc(1, program->output_size);
    one->result = calloc(1, program->output_size);
    if (record != NULL)
        one->record_name = name_of_record(record, robot, c->count);
    if (one->state == NULL || one->input == NULL || one->output == NULL || one->result == NULL ||
        (record != NULL && one->record_name == NULL)) {
        fprintf(stderr, "error: not enough memory for the program's state\n");
        return false;
    }
    if (!claims_open(&one->claims, program))
        return false;
    if (!record_open(&one->record, program, c->params, one->record_name))
        return false;
    frob_console_start(program, one->input);
    program->reset(one->state, c->params);
    return true;
}

static bool is_of_a_pair(const char *label)
{
    return strcmp(label, "left") == 0 || strcmp(label, "right") == 0;
}

/* Prints the names of the robot's cameras that are not part of a stereo head. Returns false if
 * there are none. */
static bool tell_other_cameras(const struct frob_sim *sim)
{
    const char *name, *before = " no camera with this name; it has";
    for (size_t i = 0; (name = frob_sim_camera_name(sim, i)) != NULL; i++) {
        if (is_of_a_pair(name))
            continue;
        fprintf(stderr, "%s `%s`", before, name);
        before = ",";
    }
    return *before == ',';
}

/* Prints an error that names the table to add to the world file. A single table describes both
 * cameras of a stereo head. */
static void tell_missing_camera(const struct frob_sim *sim, const char *label)
{
    const bool is_pair = is_of_a_pair(label);
    const char *table = is_pair ? "[stereo]" : "[camera]";
    fprintf(stderr, "error: the program uses a camera, `%s`, but the robot in this world has",
            label);
    if (!is_pair && tell_other_cameras(sim))
        fprintf(stderr,
                ": add `name = \"%s\"` to one of them in the world file, or write [[camera]] for "
                "each and add another one\n",
                label);
    else if (is_pair || strcmp(label, "camera") == 0)
        fprintf(stderr, " no camera: add a table %s to the world file\n", table);
    else
        fprintf(stderr, " no camera: add a table %s with name = \"%s\" to the world file\n", table,
                label);
}

/* Returns the number of the camera that control `i` uses. Controls with the same label share a
 * camera. On failure, prints an error and returns -1. */
static int look_through(struct controllers *c, size_t i)
{
    const struct frob_control *console = c->program->console;
    const size_t length = frob_camera_label(&console[i]);
    char *label;
    int number;
    for (size_t k = 0; k < i; k++)
        if (frob_camera_label(&console[k]) == length && c->cameras[k] >= 0 &&
            strncmp(console[k].label, console[i].label, length) == 0)
            return c->cameras[k];
    label = (char *)calloc(1, length + 1);
    if (label == NULL) {
        fprintf(stderr, "error: not enough memory for the cameras\n");
        return -1;
    }
    memcpy(label, console[i].label, length);
    number = frob_sim_look_through(c->sim, label);
    if (number < 0)
        tell_missing_camera(c->sim, label);
    free(label);
    return number;
}

/* Opens the tag finder and, by their labels, the cameras that the program uses. */
static bool open_cameras(struct controllers *c)
{
    const struct frob_program *program = c->program;
    bool ok = true;
    c->cameras = (int *)calloc(program->control_count + 1, sizeof *c->cameras);
    c->frames = (const struct frob_image **)calloc(program->control_count + 1, sizeof *c->frames);
    if (c->cameras == NULL || c->frames == NULL) {
        fprintf(stderr, "error: not enough memory for the cameras\n");
        return false;
    }
    for (size_t i = 0; i < program->control_count; i++) {
        c->cameras[i] = -1;
        if (frob_camera_label(&program->console[i]) == 0)
            continue;
        c->cameras[i] = look_through(c, i);
        ok = ok && c->cameras[i] >= 0;
        if (ok && program->console[i].kind == FROB_TAGS && c->finder.detector == NULL)
            ok = tag_finder_open(&c->finder);
    }
    return ok;
}

bool controllers_open(struct controllers *c, const struct params *params, struct frob_sim *sim,
                      const char *record)
{
    memset(c, 0, sizeof *c);
    c->program = params->program;
    c->params = params->values;
    c->sim = sim;
    c->each = (struct controller *)calloc(frob_sim_robots(sim), sizeof *c->each);
    c->rest = calloc(1, c->program->output_size + 1);
    if (c->each == NULL || c->rest == NULL) {
        fprintf(stderr, "error: not enough memory for the robots\n");
        return false;
    }
    c->running = c->count = frob_sim_robots(sim);
    for (size_t k = 0; k < c->count; k++)
        c->each[k].record.file.file = -1;
    for (size_t k = 0; k < c->count; k++)
        if (!open_one(c, k, record))
            return false;
    return devices_open(&c->devices, c->program, sim) && open_cameras(c);
}

/* Passes each new frame once to all controls that use its camera. */
static bool look(struct controllers *c, size_t robot, int64_t now_ns)
{
    const struct frob_program *program = c->program;
    void *input = c->each[robot].input;
    bool ok = true;
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        struct frob_tags tags;
        size_t first = 0;
        if (c->cameras[i] < 0)
            continue;
        while (c->cameras[first] != c->cameras[i])
            first++;
        c->frames[i] =
            first < i ? c->frames[first] : frob_sim_frame(c->sim, robot, c->cameras[i], now_ns);
        if (control->kind == FROB_CAMERA) {
            frob_camera_give(control, input, c->frames[i], now_ns);
            continue;
        }
        if (c->frames[i] != NULL)
            ok = tag_finder_find(&c->finder, c->frames[i], &tags) && ok;
        frob_tags_give(control, input, c->frames[i], c->frames[i] != NULL ? &tags : NULL, now_ns);
    }
    return ok;
}

static void command_rest(struct controllers *c, size_t k, int64_t now_ns)
{
    frob_sim_command_robot(c->sim, k, now_ns, c->rest);
}

bool controllers_step(struct controllers *c, int64_t now_ns, const struct touches *touches)
{
    const struct frob_program *program = c->program;
    const int64_t dt_ns = c->has_stepped ? now_ns - c->stepped_ns : 0;
    const double dt = (double)dt_ns / 1e9;
    bool ok = true;
    c->is_away = frob_sim_is_away(c->sim, now_ns) != 0;
    c->rests = c->rests || c->is_away;
    for (size_t k = 0; c->is_away && k < c->count; k++)
        command_rest(c, k, now_ns);
    if (c->is_away)
        return true;
    for (size_t k = 0; k < c->count; k++) {
        struct controller *one = &c->each[k];
        frob_sim_read_robot(c->sim, k, one->input);
        frob_console_clear(program, one->input);
        devices_give(&c->devices, k, now_ns, one->input);
        ok = look(c, k, now_ns) && ok;
        touches_apply(touches, one->input);
        memset(one->output, 0, program->output_size);
        if (!program->is_valid(one->state)) {
            command_rest(c, k, now_ns);
            fprintf(stderr, "error: the state of %s is damaged: " FROB_DAMAGED_STATE "\n",
                    program->name);
            return false;
        }
        program->step(one->state, c->params, dt_ns, dt, one->input, one->output);
        if (c->rests)
            command_rest(c, k, now_ns);
        else
            frob_sim_command_robot(c->sim, k, now_ns, one->output);
        ok = record_row(&one->record, now_ns, one->input, one->output) && ok;
        claims_see(&one->claims, now_ns, one->output);
        if (!one->ended && frob_has_ended(program, one->output)) {
            one->ended = true;
            one->ended_ns = now_ns;
            memcpy(one->result, one->output, program->output_size);
            c->running--;
        }
    }
    c->has_stepped = true;
    c->stepped_ns = now_ns;
    c->rests = false;
    return ok;
}

const struct claims *controllers_violated(const struct controllers *c)
{
    for (size_t k = 0; k < c->count; k++)
        if (c->each[k].claims.violated != NULL)
            return &c->each[k].claims;
    return NULL;
}

bool controllers_close(struct controllers *c)
{
    bool ok = true;
    for (size_t k = 0; k < c->count; k++) {
        struct controller *one = &c->each[k];
        ok = record_close(&one->record) && ok;
        claims_close(&one->claims);
        free(one->state);
        free(one->input);
        free(one->output);
        free(one->result);
        free(one->record_name);
    }
    free(c->each);
    free(c->rest);
    free(c->cameras);
    free(c->frames);
    tag_finder_close(&c->finder);
    devices_close(&c->devices);
    return ok;
}
