#include "supervisor.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "hal/posix/clock.h"
#include "realtime.h"
#include "run.h"
#include "session.h"
#include "summary.h"
#include <frob/console.h>
#include <frob/result.h>

#define JUDGE_NS INT64_C(1000000000)    /* period at which verdicts are published */
#define BEAT_NS INT64_C(20000000)       /* maximum time between heartbeats to the guards */
#define FAREWELL_NS INT64_C(2000000000) /* maximum time to come to rest after a stop command */
enum { GIVE_UP = 10 }; /* maximum duration of a step, as a multiple of `--patience` */

static volatile sig_atomic_t ended_by = 0;

static void on_signal(int number)
{
    ended_by = number;
}

/* ---- The controller */

/* Handles a step that takes longer than `--patience`: stops the robot. The step's output will be
 * discarded. */
static void be_late(struct run *s)
{
    s->late = true;
    s->late_steps++;
    session_halt(s);
    run_tell(s, "a step takes longer than %g s: stopping the robot", s->options->patience_s);
}

/* Publishes the verdicts once a second, and when an assertion starts or stops failing. */
static void publish_claims(struct run *s)
{
    const struct line_opening *opening = s->line.opening;
    const int64_t now = run_now_ns();
    size_t failing = 0;
    if (opening == NULL || opening->judge == NULL || !line_is_open(&s->line))
        return;
    for (size_t i = 0; i < s->program->claim_count; i++)
        failing += s->claims.each[i].fails ? 1 : 0;
    if (failing == s->failing && now - s->judged_ns < JUDGE_NS)
        return;
    s->failing = failing;
    s->judged_ns = now;
    for (size_t i = 0; i < s->program->claim_count; i++) {
        char fate[CLAIMS_FATE];
        claims_fate(&s->claims, i, fate);
        opening->judge(&s->line, i, s->claims.each[i].fails, s->claims.is_void, fate);
    }
}

/* Handles the end of a step: records it, and sends its output to the robot if it ended in
 * time. */
static void answered(struct run *s)
{
    int64_t took_ns = run_now_ns() - s->asked_ns;
    s->stepping = false;
    s->steps++;
    if (took_ns > s->longest_ns)
        s->longest_ns = took_ns;
    if (!s->late && took_ns > s->patience_ns)
        be_late(s);
    if (!s->late && session_is_ready(s))
        frob_robot_command(&s->robot, s->output);
    if (!s->record_ended && !record_row(&s->record, s->instant_ns, s->input, s->output))
        run_end(s, FAULT, "the recording could not be written");
    instants_put(&s->instants, &s->line, s->instant_ns, s->input, s->output);
    if (s->line.opening != NULL && s->line.opening->show != NULL && line_is_open(&s->line))
        s->line.opening->show(&s->line, s->output);
    publisher_put(&s->publisher, s->instant_ns, s->input, s->output, NULL);
    claims_see(&s->claims, s->instant_ns, s->output);
    publish_claims(s);
    if (s->options->stop_when_violated && s->claims.violated != NULL)
        run_end(s, FAULT, "\"%s\" (%s) was violated at %.3f s", s->claims.violated->label,
                s->claims.violated->place, (double)s->claims.violated_ns * 1e-9);
    if (!s->ended && frob_has_ended(s->program, s->output)) {
        s->ended = true;
        s->ended_ns = s->instant_ns;
        if (s->options->exit_when_done)
            run_end(s, DONE, "%s", "");
    }
}

static void look_after_controller(struct run *s)
{
    int64_t now = run_now_ns(), asked_ns = s->asked_ns;
    const char *fate;
    switch (controller_take(&s->controller, s->output)) {
    case CONTROLLER_ANSWERED: answered(s); return;
    case CONTROLLER_GONE:
        session_halt(s); /* before anything else */
        fate = controller_end(&s->controller, 100);
        run_end(s, FAULT, "the controller %s", fate != NULL ? fate : "has ended");
        return;
    case CONTROLLER_BUSY: break;
    }
    if (!s->stepping)
        return;
    if (!s->late && now - asked_ns > s->patience_ns)
        be_late(s);
    if (asked_ns < s->awake_ns)
        asked_ns = s->awake_ns;
    if (now - asked_ns > GIVE_UP * s->patience_ns)
        run_end(s, FAULT, "the controller has not finished a step for %g s",
                (double)GIVE_UP * s->options->patience_s);
}

/* Restarts the program in its initial state. A recording contains only one run, so it ends here. */
static void reset_program(struct run *s)
{
    s->ended = false;
    if (!s->started)
        return;
    if (s->options->record != NULL && !s->record_ended)
        fprintf(stderr, "warning: the recording ends here, because the program was reset\n");
    s->record_ended = true;
    instants_reset(&s->instants);
    if (!controller_reset(&s->controller, s->input))
        look_after_controller(s);
}

/* Carries out the requests of other programs. */
static void obey(struct run *s)
{
    struct line_orders orders;
    if (s->line.opening == NULL || s->line.opening->orders == NULL || s->stepping)
        return;
    orders = s->line.opening->orders(s->device);
    if (orders.ends)
        run_end(s, DONE, "%s", "");
    if (orders.pauses && !s->paused)
        session_halt(s);
    s->was_paused = s->was_paused || orders.pauses;
    s->paused = orders.pauses;
    if (orders.resets != s->resets)
        reset_program(s);
    s->resets = orders.resets;
}

/* Starts the next instant if it is due. Instants are due at multiples of the period after the robot
 * became ready; dt is measured. If an instant is so late that later ones are already due, those are
 * skipped and counted as overruns. */
static void next_instant(struct run *s)
{
    int64_t now = run_now_ns(), time = run_program_ns(s, now), missed, before;
    if (!session_is_ready(s) || s->over || s->paused) {
        s->scheduled = false;
        return;
    }
    if (time == INT64_MIN || s->stepping)
        return;
    if (!s->scheduled) {
        s->scheduled = true;
        s->due_ns = time;
    }
    if (time < s->due_ns)
        return;
    missed = (time - s->due_ns) / s->period_ns;
    s->overruns += (uint64_t)missed;
    s->due_ns += (missed + 1) * s->period_ns;
    if (!s->started)
        s->first_ns = time;
    else if (s->was_paused)
        s->first_ns = time - s->instant_ns - s->period_ns;
    s->started = true;
    s->was_paused = false;
    before = s->instant_ns;
    s->instant_ns = time - s->first_ns;
    s->asked_ns = now;
    frob_robot_sense(&s->robot, s->input);
    frob_console_clear(s->program, s->input);
    if (s->line.opening != NULL && s->line.opening->give != NULL)
        s->line.opening->give(s->device, s->program, s->input, now);
    cameras_look(&s->cameras, s->input, now - s->instant_ns, s->instant_ns);
    touches_take(&s->touches, &s->console, &s->publisher.ring);
    touches_apply(&s->touches, s->input);
    s->stepping = true;
    s->late = false;
    if (!controller_ask(&s->controller, s->instant_ns - before, s->input))
        look_after_controller(s);
}

/* ---- The loop */

static int64_t earlier(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

static void wait_for_something(struct run *s)
{
    int64_t now = run_now_ns(), until = now + BEAT_NS, left;
    struct pollfd inputs[2] = { { s->line.port.fd, POLLIN, 0 },
                                { s->controller.socket, POLLIN, 0 } };
    struct timespec patience;
    if (line_is_open(&s->line))
        until = earlier(until, frob_robot_due_ns(&s->robot));
    /* A simulator's clock advances only when a message arrives. */
    if (session_is_ready(s) && !s->stepping && !s->paused && run_follows_our_clock(s, now))
        until = earlier(until, s->scheduled ? s->due_ns : now);
    if (s->stepping && !s->late)
        until = earlier(until, s->asked_ns + s->patience_ns + 1);
    left = until > now ? until - now : 0;
    patience.tv_sec = (time_t)(left / 1000000000);
    patience.tv_nsec = (long)(left % 1000000000);
    ppoll(inputs, 2, &patience, &s->waiting_mask);
}

/* Detects that this process was suspended. The controller may have been suspended, too, so it gets
 * more time for its step. */
static void note_own_gap(struct run *s)
{
    int64_t now = run_now_ns();
    if (s->looped_ns == 0 || now - s->looped_ns > s->patience_ns)
        s->awake_ns = now;
    s->looped_ns = now;
}

static void run(struct run *s)
{
    while (!s->over) {
        note_own_gap(s);
        guards_hear(&s->guards);
        ring_show_alive(&s->publisher.ring);
        look_after_controller(s);
        if (!s->over)
            session_look_after(s);
        obey(s);
        next_instant(s);
        cameras_hear(&s->cameras);
        if (s->options->duration_s > 0.0 && s->started && !s->stepping && !s->paused &&
            !s->was_paused &&
            (double)(run_program_ns(s, run_now_ns()) - s->first_ns) >= s->options->duration_s * 1e9)
            run_end(s, DONE, "%s", "");
        if (ended_by != 0)
            run_end(s, FAULT, "the run was ended by %s",
                    ended_by == SIGINT ? "an interrupt" : strsignal(ended_by));
        if (ring_is_stopped(&s->publisher.ring))
            run_end(s, FAULT, "the run was ended by the Stop button on its page");
        if (!s->over)
            wait_for_something(s);
    }
}

/* Stops the robot, waits until it stands still, and disconnects. Returns the result. */
static enum ring_fate say_farewell(struct run *s)
{
    enum ring_fate fate;
    int64_t until;
    ring_stopping(&s->publisher.ring);
    if (!line_is_open(&s->line))
        return RING_NOT_REACHED;
    session_halt(s);
    until = run_now_ns() + FAREWELL_NS;
    while (s->robot.state != FROB_ROBOT_CONNECTING && run_now_ns() < until &&
           frob_robot_poll(&s->robot) != FROB_ROBOT_FAILED && !frob_robot_stands(&s->robot)) {
        struct frob_serial serial = frob_posix_serial(&s->line.port);
        guards_hear(&s->guards);
        ring_show_alive(&s->publisher.ring);
        serial.operations->wait(serial.port, earlier(until, run_now_ns() + BEAT_NS));
    }
    if (s->robot.state == FROB_ROBOT_FAILED || s->robot.state == FROB_ROBOT_CONNECTING)
        fate = RING_NOT_REACHED;
    else
        fate = frob_robot_stands(&s->robot) ? RING_AT_REST : RING_TOLD;
    frob_robot_close(&s->robot);
    guards_end(&s->guards);
    line_close(&s->line);
    return fate;
}

/* ---- Setting up */

static void catch_signals(struct run *s)
{
    static const int caught[] = { SIGINT, SIGTERM, SIGHUP };
    struct sigaction action;
    sigset_t blocked;
    memset(&action, 0, sizeof action);
    sigemptyset(&blocked);
    action.sa_handler = on_signal;
    for (size_t i = 0; i < sizeof caught / sizeof caught[0]; i++) {
        sigaction(caught[i], &action, NULL);
        sigaddset(&blocked, caught[i]);
    }
    /* Ctrl-Z must not suspend a process that drives a robot. */
    signal(SIGTSTP, SIG_IGN);
    signal(SIGTTOU, SIG_IGN);
    signal(SIGPIPE, SIG_IGN);
    sigprocmask(SIG_BLOCK, &blocked, &s->waiting_mask);
    for (size_t i = 0; i < sizeof caught / sizeof caught[0]; i++)
        sigdelset(&s->waiting_mask, caught[i]);
}

static bool set_up(struct run *s)
{
    char message[512];
    enum frob_status status;
    s->device = calloc(1, s->driver->device_size + 1);
    s->input = calloc(1, s->program->input_size + 1);
    s->output = calloc(1, s->program->output_size + 1);
    if (s->device == NULL || s->input == NULL || s->output == NULL) {
        fprintf(stderr, "error: not enough memory\n");
        return false;
    }
    if (!claims_open(&s->claims, s->program))
        return false;
    if (!touches_start(&s->touches, s->program))
        return false;
    instants_open(&s->instants, s->all_params, &s->line);
    frob_console_start(s->program, s->input);
    status = line_open(&s->line, message, sizeof message);
    if (status != FROB_OK) {
        fprintf(stderr, "error: %s\n", message);
        return false;
    }
    if (!record_open(&s->record, s->program, s->params, s->options->record)) {
        line_close(&s->line);
        return false;
    }
    return true;
}

int supervise(const struct params *params, const struct frob_driver *driver,
              const struct options *options)
{
    struct run s;
    bool has_run;
    memset(&s, 0, sizeof s);
    s.options = options;
    s.program = params->program;
    s.all_params = params;
    s.params = params->values;
    s.driver = driver;
    s.patience_ns = (int64_t)llround(options->patience_s * 1e9);
    s.period_ns = (int64_t)llround(1e9 / options->rate_hz);
    s.tells = options->progress || isatty(STDERR_FILENO) != 0;
    s.record.file.file = -1;
    if (options->opening != NULL)
        line_init_opening(&s.line, options->opening, options->arguments, options->argument_count,
                          options->settings, params);
    else
        line_init(&s.line, options->device, driver->rate);
    /* Starts the viewer before the signal handlers are set and the robot's line is opened. */
    publisher_start(&s.publisher, s.program, 0, options->control ? RING_SENDS : 0, options->viewer);
    catch_signals(&s);
    /* Starts these processes before the line is opened, so that neither the camera processes
     * nor the controller inherits it. The controller shares the memory of the cameras'
     * frames. */
    if (!cameras_start(&s.cameras, s.program, options->cameras, options->camera_count, s.tells) ||
        !controller_start(&s.controller, params, options)) {
        cameras_end(&s.cameras);
        publisher_end(&s.publisher, RING_NOT_REACHED);
        publisher_leave(&s.publisher, false);
        return WRONG_USE;
    }
    s.status = WRONG_USE;
    has_run = set_up(&s);
    if (has_run) {
        realtime_apply(options, REALTIME_SUPERVISOR);
        session_begin(&s);
        if (options->console)
            console_open(&s.console);
        run(&s);
        console_close(&s.console);
        publisher_end(&s.publisher, say_farewell(&s));
        if (!summary_print(&s) && s.status == DONE)
            s.status = WRONG_USE;
        if (ended_by == SIGINT)
            record_report_interruption(options->record, (double)s.instant_ns * 1e-9);
        if (s.status != DONE && s.cause[0] != '\0')
            fprintf(stderr, "error: %s; %s\n", s.cause,
                    s.robot.status == FROB_LOST ? "the robot could not be reached to stop it"
                                                : "sent a stop command to the robot");
    } else {
        publisher_end(&s.publisher, RING_NOT_REACHED);
    }
    controller_end(&s.controller, 0);
    cameras_end(&s.cameras);
    if (!record_close(&s.record) && s.status == DONE)
        s.status = WRONG_USE;
    publisher_leave(&s.publisher, has_run && (ended_by == 0 || ended_by == SIGINT));
    touches_end(&s.touches);
    instants_close(&s.instants);
    claims_close(&s.claims);
    free(s.device);
    free(s.input);
    free(s.output);
    return s.status;
}
