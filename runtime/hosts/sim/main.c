/* frob-sim -- runs a compiled robot program in the simulator.
 *
 * Prints a summary with one `name: value unit` per line. Exit status: 0; 2 for a usage error, an
 * unreadable file, or a program for another robot; 4 with --strict if the robot collided with
 * something, or with --stop-when-violated if an assertion was violated. SIGINT, SIGTERM and SIGHUP
 * end the run early; the summary and the picture then cover the completed part. SIGTERM and SIGHUP
 * are then raised again, which ends the process. */
#include "../common/console.h"
#include "../common/load.h"
#include "../common/params.h"
#include "../common/frames.h"
#include "../common/streams.h"
#include "../common/touches.h"
#include "../common/truth.h"
#include "controllers.h"
#include "many.h"
#include "options.h"
#include "pace.h"
#include "summary.h"
#include "trial.h"

#include <frob/console.h>
#include <sim.h>

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

enum { DONE = 0, WRONG_USE = 2, FAULT = 4 };

enum { ENDS_WITHIN_S = 2 };

static volatile sig_atomic_t interrupted = 0; /* number of the signal */

/* The alarm ends the process even if a step never returns from the user's C code. */
static void interrupt(int signal_number)
{
    interrupted = signal_number;
    alarm(ENDS_WITHIN_S);
}

static void catch_signals(void)
{
    static const int caught[] = { SIGINT, SIGTERM, SIGHUP };
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = interrupt;
    for (size_t i = 0; i < sizeof caught / sizeof caught[0]; i++)
        sigaction(caught[i], &action, NULL);
}

static int64_t clock_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

/* Prints the progress on a single line of the terminal. */
static void show_progress(int64_t now_ns, double duration_s)
{
    const double now_s = (double)now_ns * 1e-9;
    struct winsize size;
    const int room =
        ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? (int)size.ws_col - 1 : 79;
    char text[100];
    if (!isfinite(duration_s))
        snprintf(text, sizeof text, "simulating: %.0f s", now_s);
    else
        snprintf(text, sizeof text, "simulating: %.0f of %g s (%.0f %%)", now_s, duration_s,
                 duration_s > 0.0 ? 100.0 * now_s / duration_s : 100.0);
    fprintf(stderr, "\r\033[K%.*s", room, text);
    fflush(stderr);
}

/* Loads the program, and checks that it is for a robot. */
static const struct frob_program *load(const char *path)
{
    const struct frob_program *program = frob_load(path);
    if (program == NULL)
        return NULL;
    if (program->node != NULL) {
        fprintf(stderr,
                "error: %s is a ROS 2 node with topics of its own, not a program for a robot: use "
                "`frobc run --ros2`; without ROS, `frobc trace` runs it on recorded input, and "
                "`frobc test` runs its tests (`test`, not `trial`)\n",
                program->name);
        return NULL;
    }
    if (program->robot[0] == '\0') {
        fprintf(stderr, "error: %s is not a robot program; use `reactimateRobot` to make one\n",
                program->name);
        return NULL;
    }
    return program;
}

/* Prints each line of a message as an error. */
static void tell_faults(char *message)
{
    for (char *line = strtok(message, "\n"); line != NULL; line = strtok(NULL, "\n"))
        fprintf(stderr, "error: %s\n", line);
}

/* Opens the world with the program's robot in it. On failure, returns NULL and prints a line for
 * each fault on standard error. */
static struct frob_sim *open_world(const struct options *options,
                                   const struct frob_program *program)
{
    char message[8192];
    struct frob_sim_settings settings;
    struct frob_sim *sim;
    settings.robot = program->robot;
    settings.seed = options->seed;
    settings.wall_distance_m = options->wall_distance_m;
    settings.picture = options->picture != NULL;
    settings.served = 0;
    settings.body = (const struct frob_body *)frob_load_part(program->robot, "body");
    sim = frob_sim_open(options->world, &settings, message, sizeof message);
    if (sim == NULL) {
        tell_faults(message);
        return NULL;
    }
    if (program->input_size < frob_sim_input_size(sim) ||
        program->output_size < frob_sim_output_size(sim)) {
        fprintf(stderr,
                "error: %s was compiled with another version of <frob/%s.h>; compile it again\n",
                program->name, program->robot);
        frob_sim_close(sim);
        return NULL;
    }
    return sim;
}

static struct truth truth_of(struct frob_sim_place place, double touches)
{
    const struct truth truth = { place.x_m, place.y_m, place.heading_rad, touches };
    return truth;
}

/* Publishes the first robot's instant, and the true poses of all robots and of the objects that can
 * move, for viewers. */
static void publish(struct publisher *publisher, const struct controllers *controllers,
                    int64_t now_ns, struct truth *truths)
{
    const struct controller *first = &controllers->each[0];
    const struct frob_sim *sim = controllers->sim;
    if (publisher->ring.shared == NULL || controllers->is_away)
        return;
    for (size_t i = 0; i < controllers->count; i++) {
        const struct frob_sim_place place = frob_sim_place_robot(sim, i);
        truths[i] = truth_of(place, place.touches ? 1.0 : 0.0);
    }
    for (size_t i = 0; i < frob_sim_objects(sim); i++)
        truths[controllers->count + i] = truth_of(frob_sim_place_object(sim, i), TRUTH_OBJECT);
    publisher_put(publisher, now_ns, first->input, first->output, truths);
}

/* Runs the controllers at their instants. Instant k is at the absolute time k / rate, in whole
 * nanoseconds, and dt is the difference between two such times, so rounding errors do not
 * accumulate. Returns false if a recording cannot be written. */
static bool run(const struct options *options, struct controllers *controllers,
                struct console *console, struct touches *touches, struct publisher *publisher,
                struct truth *truths)
{
    struct pace pace;
    bool progress = options->progress || isatty(STDERR_FILENO);
    int64_t end_ns =
        isfinite(options->duration_s) ? (int64_t)llround(options->duration_s * 1e9) : INT64_MAX;
    int64_t shown_ns = 0;
    bool ok = true;
    pace_start(&pace, publisher, &interrupted, !options->realtime);
    for (int64_t k = 0; ok && !interrupted; k++) {
        int64_t now_ns = (int64_t)llround((double)k * 1e9 / options->rate_hz);
        if (now_ns > end_ns || !pace_wait(&pace, now_ns))
            break;
        touches_take(touches, console, &publisher->ring);
        frob_sim_advance(controllers->sim, now_ns);
        ok = controllers_step(controllers, now_ns, touches);
        publish(publisher, controllers, now_ns, truths);
        if (controllers->running == 0 && options->exit_when_done)
            break;
        if (options->stop_when_violated && controllers_violated(controllers) != NULL)
            break;
        if (progress && (k & 15) == 0 && clock_ns() - shown_ns > 100000000) {
            show_progress(now_ns, options->duration_s);
            shown_ns = clock_ns();
        }
    }
    if (progress)
        fprintf(stderr, "\r\033[K");
    return ok;
}

/* Viewers find camera frames next to the recording, so a program that uses images must be
 * recorded. */
static bool has_frames_for_viewer(const struct options *options, const struct frob_program *program)
{
    if (options->viewer == NULL || options->record != NULL || !frames_has_images(program->input))
        return true;
    fprintf(stderr, "error: this program uses a camera, and the viewer reads its frames from a "
                    "recording: add `--record LOG.csv` to `--view`\n");
    return false;
}

/* Checks that the file can be written, so that a fault is reported before the run rather than after
 * it. Removes the file if it did not exist before. */
static bool is_writable(const char *path)
{
    FILE *file = fopen(path, "rb");
    bool is_new = file == NULL;
    if (file != NULL)
        fclose(file);
    file = fopen(path, "ab");
    if (file == NULL) {
        fprintf(stderr, "error: cannot write %s: %s\n", path, strerror(errno));
        return false;
    }
    fclose(file);
    if (is_new)
        remove(path);
    return true;
}

/* Runs the program in an open simulation, and prints the summary. */
static int simulate(const struct options *options, const struct params *params,
                    struct frob_sim *sim)
{
    char message[1024];
    struct controllers controllers;
    struct console console;
    struct touches touches;
    struct publisher publisher;
    const size_t truth_count = frob_sim_robots(sim) + frob_sim_objects(sim);
    struct truth *truths = (struct truth *)calloc(truth_count, sizeof *truths);
    bool ok = touches_start(&touches, params->program) && truths != NULL;
    int64_t started_ns;
    double wall_s;
    int collisions = 0;
    bool violated = false;
    if ((options->picture != NULL && !is_writable(options->picture)) ||
        !has_frames_for_viewer(options, params->program)) {
        touches_end(&touches);
        free(truths);
        return WRONG_USE;
    }
    /* Starts the viewer before opening files that it must not inherit. */
    publisher_start(&publisher, params->program, truth_count * sizeof *truths,
                    RING_PACES | RING_SENDS, ok ? options->viewer : NULL);
    ok = controllers_open(&controllers, params, sim, options->record) && ok;
    started_ns = clock_ns();
    memset(&console, 0, sizeof console);
    if (options->console)
        console_open(&console);
    ok = ok && run(options, &controllers, &console, &touches, &publisher, truths);
    alarm(0);
    publisher_end(&publisher, RING_AT_REST);
    touches_end(&touches);
    free(truths);
    console_close(&console);
    wall_s = (double)(clock_ns() - started_ns) * 1e-9;
    if (ok && options->picture != NULL &&
        !frob_sim_picture(sim, options->picture, message, sizeof message)) {
        fprintf(stderr, "error: %s\n", message);
        ok = false;
    }
    if (ok)
        collisions = summary_print(options, &controllers, wall_s);
    ok = streams_flush() && ok;
    if (ok && options->stop_when_violated)
        violated = controllers_violated(&controllers) != NULL;
    if (violated)
        claims_complain(controllers_violated(&controllers));
    ok = controllers_close(&controllers) && ok;
    publisher_leave(&publisher, interrupted == 0 || interrupted == SIGINT);
    if (ok && interrupted == SIGINT)
        record_report_interruption(options->record, frob_sim_summarize(sim).time_s);
    if (!ok)
        return WRONG_USE;
    if (options->strict && collisions > 0) {
        fprintf(stderr, controllers.count == 1 ? "error: the robot collided with something\n"
                                               : "error: a robot collided with something\n");
        return FAULT;
    }
    return violated ? FAULT : DONE;
}

/* Prints the name of a world's robot; nothing if the world does not specify one. */
static int tell_robot(const char *world)
{
    char message[8192];
    const char *robot = frob_sim_world_robot(world, message, sizeof message);
    if (robot == NULL) {
        tell_faults(message);
        return WRONG_USE;
    }
    if (robot[0] != '\0')
        puts(robot);
    return DONE;
}

/* Runs a trial with each seed, each in a new simulation. */
static int try_seeds(const struct options *options, const struct params *params,
                     const struct frob_program *judge)
{
    struct options one = *options;
    struct trial trial;
    bool ok = trial_open(&trial, judge);
    for (; ok && one.seed <= options->last_seed; one.seed++) {
        struct frob_sim *sim = open_world(&one, params->program);
        ok = sim != NULL && trial_run(&trial, &one, params, sim, stdout);
        if (sim != NULL)
            frob_sim_close(sim);
    }
    trial_close(&trial);
    return streams_flush() && ok ? DONE : WRONG_USE;
}

static int try_runs(const struct options *options, const struct frob_program *program,
                    const struct frob_program *judge)
{
    struct trial trial;
    const bool ok = trial_open(&trial, judge) && many_runs(&trial, options, program, open_world);
    trial_close(&trial);
    return streams_flush() && ok ? DONE : WRONG_USE;
}

static int tell_plan(const char *plan)
{
    char *text;
    const int ok = frob_sim_read_plan(plan, &text);
    if (text == NULL)
        fprintf(stderr, "error: not enough memory for the plan\n");
    else if (ok)
        fputs(text, stdout);
    else
        tell_faults(text);
    free(text);
    return ok && streams_flush() ? DONE : WRONG_USE;
}

static int start(const struct options *options)
{
    /* Loads the judge first, because the parts of a user-defined robot are looked up in the object
     * that was loaded last. */
    const struct frob_program *judge = options->judge != NULL ? frob_load(options->judge) : NULL;
    const struct frob_program *program = load(options->program);
    struct params params;
    struct frob_sim *sim;
    int status = WRONG_USE;
    if (program == NULL || (options->judge != NULL && judge == NULL))
        return WRONG_USE;
    if (options->judge != NULL && options->runs != NULL)
        return try_runs(options, program, judge);
    if (options->judge != NULL) {
        if (params_open(&params, program, options->params, options->param_count))
            status = try_seeds(options, &params, judge);
    } else if (params_open(&params, program, options->params, options->param_count) &&
               (sim = open_world(options, program)) != NULL) {
        catch_signals();
        streams_plain_output();
        status = simulate(options, &params, sim);
        frob_sim_close(sim);
    }
    params_close(&params);
    return status;
}

int main(int argc, char **argv)
{
    struct options options;
    int status = WRONG_USE;
    streams_open();
    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        fputs(usage, stdout);
        return DONE;
    }
    if (argc == 3 && strcmp(argv[1], "--robot-of") == 0)
        return tell_robot(argv[2]);
    if (argc == 3 && strcmp(argv[1], "--plan") == 0)
        return tell_plan(argv[2]);
    if (read_options(argc, argv, &options))
        status = start(&options);
    free(options.params);
    if (interrupted != 0 && interrupted != SIGINT) {
        signal(interrupted, SIG_DFL);
        raise(interrupted);
    }
    return status;
}
