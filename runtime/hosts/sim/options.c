#include "options.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char usage[] =
    "usage: frob-sim PROGRAM.so --world WORLD.toml [OPTION]...\n"
    "\n"
    "  --world FILE       the world of the robot\n"
    "  --for SECONDS      how long to run (60)\n"
    "  --rate HZ          how often the controller runs (50)\n"
    "  --seed N           the seed for all noise (1)\n"
    "  --param NAME=VALUE set a parameter of the program, in its unit\n"
    "  --target METRES    the distance that the robot should keep from the wall\n"
    "  --realtime         run in real time instead of as fast as possible\n"
    "  --record FILE.csv  record the inputs and outputs of the program (FILE.csv.gz: compressed)\n"
    "  --picture FILE     draw the run as .svg or .png\n"
    "  --console          pass typed keys to the program, one per instant\n"
    "  --exit-when-done   end when the program ends, even if the --for time is not up\n"
    "  --stop-when-violated\n"
    "                     exit with status 4 when an assertion of the program is violated\n"
    "  --strict           exit with status 4 if the robot collided with something\n"
    "  --judge JUDGE.so   judge each run, and print a line for it instead of a summary\n"
    "  --last-seed N      with --judge: run with each seed from the --seed value to N\n"
    "  --runs LIST        with --judge: run each line of a list, with its seed and parameters\n"
    "  --progress         show progress even if standard error is not a terminal\n"
    "  --viewer COMMAND...\n"
    "                     start this viewer and run in real time; without --for, run\n"
    "                     until interrupted; must be the last option\n"
    "\n"
    "       frob-sim --robot-of WORLD.toml\n"
    "\n"
    "                     prints the robot that a world names, if any\n"
    "\n"
    "       frob-sim --plan PLAN.toml\n"
    "\n"
    "                     prints the contents of a sweep's plan\n";

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

static bool whole(const char *option, const char *text, uint64_t *result)
{
    char *end;
    errno = 0;
    *result = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || errno != 0) {
        fprintf(stderr, "error: %s takes a whole number, not `%s`\n", option, text);
        return false;
    }
    return true;
}

/* Returns the variable for an option without a value; NULL if there is no such
 * option. */
static bool *flag(struct options *o, const char *name)
{
    if (strcmp(name, "--realtime") == 0)
        return &o->realtime;
    if (strcmp(name, "--strict") == 0)
        return &o->strict;
    if (strcmp(name, "--progress") == 0)
        return &o->progress;
    if (strcmp(name, "--console") == 0)
        return &o->console;
    if (strcmp(name, "--exit-when-done") == 0)
        return &o->exit_when_done;
    if (strcmp(name, "--stop-when-violated") == 0)
        return &o->stop_when_violated;
    return NULL;
}

static bool valued(struct options *o, const char *name, const char *value)
{
    if (strcmp(name, "--world") == 0)
        o->world = value;
    else if (strcmp(name, "--record") == 0)
        o->record = value;
    else if (strcmp(name, "--picture") == 0)
        o->picture = value;
    else if (strcmp(name, "--param") == 0)
        o->params[o->param_count++] = value;
    else if (strcmp(name, "--for") == 0)
        return number(name, value, 0.0, 1e5, &o->duration_s);
    else if (strcmp(name, "--rate") == 0)
        return number(name, value, 0.1, 10000.0, &o->rate_hz);
    else if (strcmp(name, "--target") == 0)
        return number(name, value, 0.001, 100.0, &o->wall_distance_m);
    else if (strcmp(name, "--seed") == 0)
        return whole(name, value, &o->seed);
    else if (strcmp(name, "--judge") == 0)
        o->judge = value;
    else if (strcmp(name, "--runs") == 0)
        o->runs = value;
    else if (strcmp(name, "--last-seed") == 0)
        return whole(name, value, &o->last_seed);
    else {
        fprintf(stderr, "error: unknown option `%s`; `frob-sim --help` lists all options\n", name);
        return false;
    }
    return true;
}

/* Before the run starts, reports a format that the simulator cannot draw. */
static bool is_picture(const char *name)
{
    size_t length = strlen(name);
    if (length > 4 &&
        (strcmp(name + length - 4, ".svg") == 0 || strcmp(name + length - 4, ".png") == 0))
        return true;
    fprintf(stderr, "error: the name of the picture `%s` must end in .svg or .png\n", name);
    return false;
}

bool read_options(int argc, char **argv, struct options *o)
{
    memset(o, 0, sizeof *o);
    o->duration_s = NAN;
    o->rate_hz = 50.0;
    o->seed = 1;
    o->params = (const char **)calloc((size_t)argc, sizeof *o->params);
    if (o->params == NULL)
        return false;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--viewer") == 0 && i + 1 < argc) {
            o->viewer = argv + i + 1;
            break;
        }
        bool *alone = flag(o, argv[i]);
        if (alone != NULL) {
            *alone = true;
        } else if (argv[i][0] != '-') {
            if (o->program != NULL) {
                fprintf(stderr, "error: there are two programs, `%s` and `%s`; give only one\n",
                        o->program, argv[i]);
                return false;
            }
            o->program = argv[i];
        } else if (i + 1 == argc) {
            fprintf(stderr, "error: the option `%s` is unknown, or its value is missing\n",
                    argv[i]);
            return false;
        } else if (!valued(o, argv[i], argv[i + 1])) {
            return false;
        } else {
            i++;
        }
    }
    if (o->last_seed == 0)
        o->last_seed = o->seed;
    if (isnan(o->duration_s))
        o->duration_s = o->viewer != NULL ? (double)INFINITY : 60.0;
    if (o->program == NULL || o->world == NULL) {
        fprintf(stderr, "error: %s is missing; see `frob-sim --help`\n",
                o->program == NULL ? "the program" : "--world");
        return false;
    }
    return o->picture == NULL || is_picture(o->picture);
}
