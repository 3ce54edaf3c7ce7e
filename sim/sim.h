/* sim.h -- the simulator, for hosts written in C.
 *
 * One simulation is one world file and the robots in it. The host owns
 * time: it says up to when the physics should run, reads the sensors, steps
 * the controller, and passes on the command.
 *
 *   struct frob_sim *sim = frob_sim_open("world.toml", &settings, message, sizeof message);
 *   for (each instant at time t) {
 *       frob_sim_advance(sim, t);
 *       frob_sim_read(sim, &input);
 *       controller(..., &input, &output);
 *       frob_sim_command(sim, t, &output);
 *   }
 *
 * Times are nanoseconds since the start. The same world, seed and commands at
 * the same times give the same readings, bit for bit. Simulations share
 * nothing; one thread at a time may use one. */
#ifndef FROB_SIM_H
#define FROB_SIM_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct frob_sim;
struct frob_image; /* <frob/image.h> */
struct frob_body;  /* <frob/body.h> */

struct frob_sim_settings {
    const char *robot; /* "pioneer", …: what the host can talk to; NULL: any */
    uint64_t seed;     /* of all noise */
    double
        wall_distance_m; /* measures a wall, with this for `distance` of the world file's [measure]; 0: as it says */
    int picture;                  /* whether to keep what frob_sim_picture shows */
    const struct frob_body *body; /* of a robot of the user's own, which is `robot`; else NULL */
};

/* Reads a world file. NULL on failure; `message` then holds a line for each
 * mistake, `FILE:LINE:COLUMN: …`, as far as there is room. */
struct frob_sim *frob_sim_open(const char *world_file, const struct frob_sim_settings *settings,
                               char *message, size_t room);
void frob_sim_close(struct frob_sim *sim);

/* The sizes of the structs of the robot (the world's if that names one, else the
 * settings', else a pioneer), which its header <frob/ROBOT.h> declares. */
size_t frob_sim_input_size(const struct frob_sim *sim);
size_t frob_sim_output_size(const struct frob_sim *sim);

/* The robot that a world file names: an empty text if it leaves it open. NULL
 * on failure, with a `message` as above. */
const char *frob_sim_world_robot(const char *world_file, char *message, size_t room);

/* What a plan of a sweep says, in lines (plan/plan_file.h); or 0, and a line for each mistake.
 * The text is to be freed; NULL without memory. */
int frob_sim_read_plan(const char *plan_file, char **text);

/* How many robots there are, all of that kind, numbered from 0 in the order of
 * the world file. What takes no number is about robot 0, in a world of several too. */
size_t frob_sim_robots(const struct frob_sim *sim);

/* Runs the physics up to this time, which must not go back. Its step is 5 ms;
 * it stops at the last step that does not go beyond. */
void frob_sim_advance(struct frob_sim *sim, int64_t time_ns);

/* The sensors, as the robot's input struct. An echo is an event of the first reading after it arrived. */
void frob_sim_read(struct frob_sim *sim, void *input);
void frob_sim_read_robot(struct frob_sim *sim, size_t robot, void *input);

/* Begins to look through the camera that the world calls so, of all robots, before the physics
 * runs. Its number, or -1 if there is none in the world. */
int frob_sim_look_through(struct frob_sim *sim, const char *camera);

/* The name of the world's camera of this number, from 0; NULL if there are not so many. */
const char *frob_sim_camera_name(const struct frob_sim *sim, size_t number);

/* The newest frame of a robot's camera that has arrived by this time, once; NULL if there is none
 * that was not given before. It stays until the next call for the same camera. */
const struct frob_image *frob_sim_frame(struct frob_sim *sim, size_t robot, int camera,
                                        int64_t time_ns);

/* What the robot does from now on, as its output struct: limited to what it can do, and rest if any
 * of it is NaN. `time_ns` is the controller's instant, for the record. */
void frob_sim_command(struct frob_sim *sim, int64_t time_ns, const void *output);
void frob_sim_command_robot(struct frob_sim *sim, size_t robot, int64_t time_ns,
                            const void *output);

/* Where a robot really is, in the world, and whether something touches it. */
struct frob_sim_place {
    double x_m, y_m, heading_rad;
    int touches;
};

struct frob_sim_place frob_sim_place_robot(const struct frob_sim *sim, size_t robot);

/* How far the middle of a robot is from the nearest wall, polygon or post; infinite in an
 * empty world. */
double frob_sim_clearance_robot(const struct frob_sim *sim, size_t robot);

struct frob_sim_summary {
    double time_s;           /* simulated */
    double distance_m;       /* along the path */
    int collisions;          /* with what stands fast, and with other robots */
    double odometry_error_m; /* between where the robot is and believes to be */
    int measured;            /* the world file says to measure the distance from a wall: */
    double wall_distance_m;  /* that the robot should keep */
    double mean_error_m;     /* since it settled; NaN if it has not */
    double largest_error_m;
    int tape_measured;  /* or that from the middle of tape on the floor: */
    double mean_tape_m; /* since it settled; NaN if it has not */
    double largest_tape_m;
    double tape_way_m;      /* come along the tape, in the order of its points */
    int ball_measured;      /* or the distance from a ball: */
    double ball_distance_m; /* that the robot should keep */
    double mean_ball_m;     /* error since it settled; NaN if it has not */
    double largest_ball_m;
};

struct frob_sim_summary frob_sim_summarize(const struct frob_sim *sim);
struct frob_sim_summary frob_sim_summarize_robot(const struct frob_sim *sim, size_t robot);

/* Draws the world, the paths, and the signals of robot 0. The file's name ends in .svg or
 * .png. Returns 1, or 0 with a line in `message`. Without `picture` in the
 * settings there is no path and no signal to be drawn. */
int frob_sim_picture(const struct frob_sim *sim, const char *file, char *message, size_t room);

#ifdef __cplusplus
}
#endif
#endif
