#include "summary.h"

#include <frob/result.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Prints the measurements of a robot; each line starts with `who`. */
static void print_wall_distance(const char *who, const struct frob_sim_summary *s)
{
    if (!s->measured)
        return;
    printf("%swall distance to keep: %.3f m\n", who, s->wall_distance_m);
    if (isnan(s->mean_error_m)) {
        printf("%swall distance error: not measured, because the run ended before "
               "the robot had settled\n",
               who);
    } else {
        printf("%smean wall distance error: %.4f m\n", who, s->mean_error_m);
        printf("%slargest wall distance error: %.4f m\n", who, s->largest_error_m);
    }
}

static void print_tape_distance(const char *who, const struct frob_sim_summary *s)
{
    if (!s->tape_measured)
        return;
    if (isnan(s->mean_tape_m)) {
        printf("%sdistance from the tape: not measured, because the run ended before "
               "the robot had settled\n",
               who);
    } else {
        printf("%smean distance from the tape: %.4f m\n", who, s->mean_tape_m);
        printf("%slargest distance from the tape: %.4f m\n", who, s->largest_tape_m);
        printf("%sdistance along the tape: %.3f m\n", who, s->tape_way_m);
    }
}

static void print_ball_distance(const char *who, const struct frob_sim_summary *s)
{
    if (!s->ball_measured)
        return;
    printf("%sball distance to keep: %.3f m\n", who, s->ball_distance_m);
    if (isnan(s->mean_ball_m)) {
        printf("%sball distance error: not measured, because the run ended before "
               "the robot had settled\n",
               who);
    } else {
        printf("%smean ball distance error: %.4f m\n", who, s->mean_ball_m);
        printf("%slargest ball distance error: %.4f m\n", who, s->largest_ball_m);
    }
}

static void print_collisions(const char *who, const struct frob_sim *sim, size_t robot, int count)
{
    struct frob_sim_collision collision;
    printf("%scollisions: %d\n", who, count);
    for (size_t i = 0; frob_sim_collision_robot(sim, robot, i, &collision); i++) {
        char text[400];
        frob_sim_describe_collision(&collision, text, sizeof text);
        printf("%s%s\n", who, text);
    }
}

static void print_robot(const char *who, const struct frob_sim *sim, size_t robot,
                        const struct frob_sim_summary *s)
{
    printf("%sdistance driven: %.3f m\n", who, s->distance_m);
    print_wall_distance(who, s);
    print_tape_distance(who, s);
    print_ball_distance(who, s);
    printf("%sodometry error at the end: %.3f m\n", who, s->odometry_error_m);
    print_collisions(who, sim, robot, s->collisions);
}

static void print_result(const char *who, const struct frob_program *program,
                         const struct controller *one)
{
    size_t room = frob_result_room(program);
    char *buffer;
    struct frob_text text;
    if (!one->ended)
        return;
    printf("%sfinished after: %.3f s\n", who, (double)one->ended_ns * 1e-9);
    buffer = (char *)malloc(room);
    if (buffer == NULL)
        return;
    text = frob_text_in(buffer, room);
    frob_result_write(&text, program, one->result);
    printf("%sresult: %s\n", who, text.data);
    free(buffer);
}

static void print_speed(const struct options *options, double time_s, double wall_s)
{
    printf("simulated seconds per second: %.0f\n", wall_s > 0.0 ? time_s / wall_s : 0.0);
    if (options->picture != NULL)
        printf("picture: %s\n", options->picture);
}

static int print_single(const struct options *options, const struct controllers *c, double wall_s)
{
    struct frob_sim_summary s = frob_sim_summarize(c->sim);
    printf("time simulated: %.3f s\n", s.time_s);
    print_robot("", c->sim, 0, &s);
    print_speed(options, s.time_s, wall_s);
    if (options->record != NULL)
        printf("log: %s\n", options->record);
    print_result("", c->program, &c->each[0]);
    claims_print(&c->each[0].claims, stdout, "");
    return s.collisions;
}

static int print_several(const struct options *options, const struct controllers *c, double wall_s)
{
    double time_s = 0.0, distance_m = 0.0;
    int collisions = 0;
    for (size_t k = 0; k < c->count; k++) {
        struct frob_sim_summary s = frob_sim_summarize_robot(c->sim, k);
        char who[32];
        snprintf(who, sizeof who, "robot %zu ", k + 1);
        print_robot(who, c->sim, k, &s);
        if (c->each[k].record_name != NULL)
            printf("%slog: %s\n", who, c->each[k].record_name);
        print_result(who, c->program, &c->each[k]);
        claims_print(&c->each[k].claims, stdout, who);
        time_s = s.time_s;
        distance_m += s.distance_m;
        collisions += s.collisions;
    }
    printf("robots: %zu\n", c->count);
    printf("time simulated: %.3f s\n", time_s);
    printf("distance driven: %.3f m\n", distance_m);
    printf("collisions: %d\n", collisions);
    print_speed(options, time_s, wall_s);
    if (c->program->result != NULL)
        printf("finished: %zu of %zu\n", c->count - c->running, c->count);
    return collisions;
}

int summary_print(const struct options *options, const struct controllers *c, double wall_s)
{
    return c->count == 1 ? print_single(options, c, wall_s) : print_several(options, c, wall_s);
}
