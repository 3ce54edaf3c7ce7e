#include "options.h"

#include "../common/frames.h"
#include "../common/params.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char device_usage[] =
    "  --device DEV       the serial line, such as /dev/ttyUSB0 or a path under\n"
    "                     /dev/serial/by-id; or tcp:HOST:PORT\n";

static const char usage[] =
    "  --for SECONDS      how long to run (until interrupted)\n"
    "  --rate HZ          how often the controller runs (50, or the rate of `node`)\n"
    "  --record FILE.csv  record the inputs and outputs of the program (FILE.csv.gz: compressed)\n"
    "  --patience SECONDS maximum age of a reading, and maximum duration of a step,\n"
    "                     before the robot is stopped (0.2)\n"
    "  --reconnect SECONDS\n"
    "                     how long to try to reconnect to the robot (30)\n"
    "  --camera SOURCE    source of the frames of the program's camera: a device, such as\n"
    "                     /dev/video0; http://HOST:PORT/PATH, an MJPEG stream; a folder of\n"
    "                     pictures; a pipe or file of pictures, or of raw frames.\n"
    "                     LABEL=SOURCE for one of several cameras\n"
    "  --param NAME=VALUE set a parameter of the program, in its unit\n"
    "  --set NAME=VALUE   change a setting of the driver, see below\n"
    "  --priority N       run with real-time priority N, 1 to 99\n"
    "  --lock-memory      lock all memory, so that none is swapped out\n"
    "  --console          pass typed keys to the program, one per instant\n"
    "  --exit-when-done   end when the program's task ends\n"
    "  --stop-when-violated\n"
    "                     stop the robot and end when an assertion is violated, if the program\n"
    "                     was built with its assertions\n"
    "  --progress         report connections even if standard error is not a terminal\n"
    "  --control          let viewers send events to the program\n"
    "  --viewer COMMAND...\n"
    "                     start this viewer; must be the last option\n"
    "\n"
    "Exit status: 0 when the run is complete; 2 for a usage error or a device that cannot be\n"
    "opened; 4 when a signal or a fault ended the run and the robot was stopped.\n";

/* Lists the parameters with their defaults. */
static void show_params(const struct frob_program *program)
{
    char room[200];
    if (program->param_count > 0)
        printf("\nParameters:\n");
    for (size_t i = 0; i < program->param_count; i++) {
        struct frob_text text = frob_text_in(room, sizeof room);
        params_write(&text, &program->params[i], program->default_params);
        printf("  %s=%s\n", program->params[i].name, room);
    }
}

/* Lists the settings of a camera, which are written LABEL.NAME. */
static void show_cameras(const struct frob_program *program)
{
    struct camera_options cameras[CAMERAS_MOST];
    size_t count = 0;
    if (!cameras_options(cameras, &count, program) || count == 0)
        return;
    printf("\nSettings of a camera, as `--set %s.up=0.5`:\n", cameras[0].label);
    for (size_t i = 0; i < CAMERA_SETTING_COUNT; i++) {
        const struct frob_setting *s = &camera_settings[i];
        printf("  %-18s %s", s->name, s->meaning);
        if (!isnan(s->initial))
            printf(" (%g)", s->initial);
        printf("\n");
    }
}

static void show_usage(const struct frob_program *program, const struct frob_driver *driver,
                       const struct line_opening *opening)
{
    const char *name = program->name;
    if (opening == NULL)
        printf("usage: %s --device DEV [OPTION]...\n\nRuns the program %s on a %s.\n\n%s", name,
               name, driver->robot, device_usage);
    else
        printf("usage: %s [OPTION]... [%s ARG...]\n\nRuns the program %s.\n\n%s", name,
               opening->option, name, opening->usage);
    printf("%s\nSettings:\n", usage);
    for (size_t i = 0; i < driver->setting_count; i++) {
        const struct frob_setting *s = &driver->settings[i];
        printf("  %-18s %s, %g to %g", s->name, s->meaning, s->least, s->greatest);
        if (isnan(s->initial))
            printf(" (default: from the robot or its model)\n");
        else
            printf(" (%g)\n", s->initial);
    }
    show_cameras(program);
    show_params(program);
}

static bool number(const char *option, const char *text, double low, double high, double *result)
{
    char *end;
    double x = strtod(text, &end);
    if (end == text || *end != '\0' || !(x >= low && x <= high)) {
        fprintf(stderr, "error: %s takes a number from %g to %g, not `%s`\n", option, low, high,
                text);
        return false;
    }
    *result = x;
    return true;
}

/* Returns the camera whose label, followed by `mark`, begins the text; NULL if there is none. */
static struct camera_options *camera_of(struct options *o, const char *text, char mark)
{
    for (size_t i = 0; i < o->camera_count; i++) {
        const size_t length = strlen(o->cameras[i].label);
        if (strncmp(text, o->cameras[i].label, length) == 0 && text[length] == mark)
            return &o->cameras[i];
    }
    return NULL;
}

/* Reads NAME=VALUE for a camera. */
static bool set_camera(struct camera_options *camera, const char *text)
{
    const char *equals = strchr(text, '=');
    const size_t length = equals != NULL ? (size_t)(equals - text) : strlen(text);
    for (size_t i = 0; i < CAMERA_SETTING_COUNT; i++) {
        const struct frob_setting *s = &camera_settings[i];
        if (strlen(s->name) == length && strncmp(s->name, text, length) == 0 && equals != NULL)
            return number(s->name, equals + 1, s->least, s->greatest, &camera->settings[i]);
    }
    fprintf(stderr,
            "error: `%s` is not a setting of a camera; write %s.NAME=VALUE with one of:", text,
            camera->label);
    for (size_t i = 0; i < CAMERA_SETTING_COUNT; i++)
        fprintf(stderr, "%s %s", i == 0 ? "" : ",", camera_settings[i].name);
    fprintf(stderr, "\n");
    return false;
}

/* Reads SOURCE or LABEL=SOURCE. */
static bool set_source(struct options *o, const char *program, const char *text)
{
    struct camera_options *camera = camera_of(o, text, '=');
    const char *source = camera != NULL ? text + strlen(camera->label) + 1 : text;
    if (camera == NULL && o->camera_count == 1)
        camera = &o->cameras[0];
    if (camera == NULL) {
        fprintf(stderr,
                o->camera_count == 0
                    ? "error: %s uses no camera: remove --camera\n"
                    : "error: %s uses several cameras: name one of them, as in --camera %s=%s\n",
                program, o->camera_count == 0 ? "" : o->cameras[0].label, text);
        return false;
    }
    camera->source = source;
    return true;
}

/* Checks that each camera has a source, and that raw frames have both a width and a height, or
 * neither. */
static bool check_cameras(const struct options *o, const char *program)
{
    for (size_t i = 0; i < o->camera_count; i++) {
        const struct camera_options *c = &o->cameras[i];
        const double width = c->settings[CAMERA_WIDTH], height = c->settings[CAMERA_HEIGHT];
        if (c->source == NULL || c->source[0] == '\0') {
            fprintf(stderr,
                    "error: %s uses a camera, `%s`: add its source with --camera %s%sSOURCE, such "
                    "as /dev/video0 or http://HOST:PORT/PATH\n",
                    program, c->label, o->camera_count > 1 ? c->label : "",
                    o->camera_count > 1 ? "=" : "");
            return false;
        }
        if ((width > 0.0) != (height > 0.0)) {
            fprintf(stderr,
                    "error: camera `%s` has only one of width and height: set both, or neither\n",
                    c->label);
            return false;
        }
        if (width * height * 3.0 > (double)BUFFERS_ROOM) {
            fprintf(stderr,
                    "error: camera `%s`: frames can have at most 1920 x 1200 pixels, not %g x %g\n",
                    c->label, width, height);
            return false;
        }
    }
    return true;
}

/* Reads NAME=VALUE for the driver. */
static bool set_driver(const struct frob_driver *driver, const char *text, double *settings)
{
    const char *equals = strchr(text, '=');
    size_t length = equals != NULL ? (size_t)(equals - text) : strlen(text);
    for (size_t i = 0; i < driver->setting_count; i++) {
        const struct frob_setting *s = &driver->settings[i];
        if (strlen(s->name) == length && strncmp(s->name, text, length) == 0 && equals != NULL)
            return number(s->name, equals + 1, s->least, s->greatest, &settings[i]);
    }
    fprintf(stderr, "error: `%s` is not a setting of a %s; write NAME=VALUE with one of:", text,
            driver->robot);
    for (size_t i = 0; i < driver->setting_count; i++)
        fprintf(stderr, "%s %s", i == 0 ? "" : ",", driver->settings[i].name);
    fprintf(stderr, "\n");
    return false;
}

static bool set(const struct frob_driver *driver, const char *text, struct options *o)
{
    struct camera_options *camera = camera_of(o, text, '.');
    return camera != NULL ? set_camera(camera, text + strlen(camera->label) + 1)
                          : set_driver(driver, text, o->settings);
}

/* Rejects a `--patience` close to 0, which would disable the watchdog or stop the robot at every
 * step. */
static bool patience(const char *text, double *result)
{
    double x;
    if (!number("--patience", text, 0.0, 2.0, &x))
        return false;
    if (x < 0.01) {
        fprintf(stderr, "error: you cannot turn off the watchdog of a robot: --patience takes a "
                        "number from 0.01 to 2 seconds\n");
        return false;
    }
    *result = x;
    return true;
}

static bool valued(const struct frob_driver *driver, const struct frob_program *program,
                   struct options *o, const char *name, const char *value)
{
    double x;
    if (strcmp(name, "--device") == 0 && o->opening == NULL)
        o->device = value;
    else if (strcmp(name, "--record") == 0)
        o->record = value;
    else if (strcmp(name, "--for") == 0)
        return number(name, value, 0.0, 1e9, &o->duration_s);
    else if (strcmp(name, "--rate") == 0)
        return number(name, value, 0.1, 1000.0, &o->rate_hz);
    else if (strcmp(name, "--patience") == 0)
        return patience(value, &o->patience_s);
    else if (strcmp(name, "--reconnect") == 0)
        return number(name, value, 0.0, 1e6, &o->reconnect_s);
    else if (strcmp(name, "--param") == 0)
        o->params[o->param_count++] = value;
    else if (strcmp(name, "--set") == 0)
        return set(driver, value, o);
    else if (strcmp(name, "--camera") == 0)
        return set_source(o, program->name, value);
    else if (strcmp(name, "--priority") == 0) {
        if (!number(name, value, 1.0, 99.0, &x))
            return false;
        o->priority = (int)x;
    } else {
        fprintf(stderr, "error: unknown option `%s`; --help lists all options\n", name);
        return false;
    }
    return true;
}

/* Stores the arguments for `opening`, from index `first` up to a `--` or the end. Returns the index
 * at which they end. */
static int pass_on(struct options *o, int argc, char **argv, int first)
{
    int end = first;
    while (end < argc && strcmp(argv[end], "--") != 0)
        end++;
    o->arguments = (const char *const *)(argv + first);
    o->argument_count = (size_t)(end - first);
    return end;
}

enum options_result read_options(int argc, char **argv, const struct frob_program *program,
                                 const struct frob_driver *driver,
                                 const struct line_opening *opening, struct options *o)
{
    memset(o, 0, sizeof *o);
    o->opening = opening;
    o->rate_hz = program->node != NULL ? program->node->rate_hz : 50.0;
    o->patience_s = 0.2;
    o->reconnect_s = 30.0;
    o->params = (const char **)calloc((size_t)argc, sizeof *o->params);
    if (o->params == NULL || !cameras_options(o->cameras, &o->camera_count, program))
        return OPTIONS_WRONG;
    for (size_t i = 0; i < driver->setting_count && i < SETTINGS_MOST; i++)
        o->settings[i] = driver->settings[i].initial;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            show_usage(program, driver, opening);
            return OPTIONS_SHOWN;
        }
        if (opening != NULL && strcmp(argv[i], opening->option) == 0) {
            i = pass_on(o, argc, argv, i + 1);
        } else if (strcmp(argv[i], "--lock-memory") == 0) {
            o->lock_memory = true;
        } else if (strcmp(argv[i], "--console") == 0) {
            o->console = true;
        } else if (strcmp(argv[i], "--exit-when-done") == 0) {
            o->exit_when_done = true;
        } else if (strcmp(argv[i], "--stop-when-violated") == 0) {
            o->stop_when_violated = true;
        } else if (strcmp(argv[i], "--progress") == 0) {
            o->progress = true;
        } else if (strcmp(argv[i], "--control") == 0) {
            o->control = true;
        } else if (strcmp(argv[i], "--viewer") == 0 && i + 1 < argc) {
            o->viewer = argv + i + 1;
            break;
        } else if (i + 1 == argc) {
            fprintf(stderr, "error: the option `%s` is unknown, or its value is missing\n",
                    argv[i]);
            return OPTIONS_WRONG;
        } else if (!valued(driver, program, o, argv[i], argv[i + 1])) {
            return OPTIONS_WRONG;
        } else {
            i++;
        }
    }
    if (o->device == NULL && opening == NULL) {
        fprintf(stderr, "error: --device is missing: add the serial line of the %s; see --help\n",
                driver->robot);
        return OPTIONS_WRONG;
    }
    if (!check_cameras(o, program->name))
        return OPTIONS_WRONG;
    if (o->viewer != NULL && o->record == NULL && frames_has_images(program->input)) {
        fprintf(stderr, "error: this program uses a camera, and the viewer reads its frames from a "
                        "recording: add `--record LOG.csv` to `--view`\n");
        return OPTIONS_WRONG;
    }
    return OPTIONS_RUN;
}
