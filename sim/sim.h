/* sim.h -- the simulator, for hosts written in C.
 *
 * A simulation consists of one world and the robots in it. The host controls time: in each cycle,
 * it runs the physics up to a given time, reads the sensors, steps the controller, and passes on
 * the command.
 *
 *   struct frob_sim *sim = frob_sim_open("world.toml", &settings, message, sizeof message);
 *   for (each instant at time t) {
 *       frob_sim_advance(sim, t);
 *       frob_sim_read(sim, &input);
 *       controller(..., &input, &output);
 *       frob_sim_command(sim, t, &output);
 *   }
 *
 * Times are nanoseconds since the start. The same world, seed, and commands at the same times
 * produce the same readings, bit for bit. Simulations share no data, so different threads may use
 * different simulations, but only one thread at a time may use each simulation. */
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
struct frob_scan;  /* <frob/lidar.h> */
struct frob_imu;   /* <frob/imu.h> */

struct frob_sim_settings {
    const char *robot; /* the robot that the host supports ("pioneer", …); NULL: any */
    uint64_t seed;     /* seed for all noise */
    /* If positive, the distance from a wall is measured, and this value overrides `distance` in the
     * world file's [measure]. If 0, the world file specifies the measurement. */
    double wall_distance_m;
    int picture; /* nonzero to record the data that frob_sim_picture draws */
    /* The body of the user-defined robot that `robot` names; NULL for any other robot. */
    const struct frob_body *body;
    /* Nonzero if commands come from firmware, which has already rounded them to whole steps. 0 if
     * the simulator must round them as the robot's driver does (drivers/steps.h). */
    int served;
};

/* Reads a world file. Returns NULL on failure; `message` then contains one line for each
 * mistake, `FILE:LINE:COLUMN: …`, truncated to `room` bytes. */
struct frob_sim *frob_sim_open(const char *world_file, const struct frob_sim_settings *settings,
                               char *message, size_t room);
void frob_sim_close(struct frob_sim *sim);

/* Sizes of the robot's input and output structs, which its header <frob/ROBOT.h> declares. The
 * robot is the one that the world file names, otherwise the one in the settings, otherwise a
 * Pioneer. */
size_t frob_sim_input_size(const struct frob_sim *sim);
size_t frob_sim_output_size(const struct frob_sim *sim);

/* Returns the robot that a world file names, or "" if it does not name one. On failure, returns
 * NULL and writes `message` as frob_sim_open does. */
const char *frob_sim_world_robot(const char *world_file, char *message, size_t room);

/* Reads the plan of a sweep. Sets `text` to the plan's contents, with one line for each item (the
 * format is in plan/plan_file.h), and returns 1. If the plan contains mistakes, sets it to one
 * line for each mistake and returns 0. The caller must free the text, which is NULL if memory runs
 * out. */
int frob_sim_read_plan(const char *plan_file, char **text);

/* Number of robots in the world, all of the same kind. They are numbered from 0 in the order of
 * the world file. Functions without a robot number refer to robot 0. */
size_t frob_sim_robots(const struct frob_sim *sim);

/* Runs the physics up to this time, which must not be earlier than in the previous call. The
 * physics runs in steps of 5 ms; it stops at the last step that is not later than this time. */
void frob_sim_advance(struct frob_sim *sim, int64_t time_ns);

/* Reads the sensors into the robot's input struct. Each echo appears as an event in the first
 * reading after it arrives. */
void frob_sim_read(struct frob_sim *sim, void *input);
void frob_sim_read_robot(struct frob_sim *sim, size_t robot, void *input);

/* Opens the camera with this name on all robots. Must be called before the physics runs. Returns
 * the camera's number, or -1 if the world has no camera with this name. */
int frob_sim_look_through(struct frob_sim *sim, const char *camera);

/* Name of the world's camera with this number, counted from 0; NULL if there is no such camera. */
const char *frob_sim_camera_name(const struct frob_sim *sim, size_t number);

/* Returns the newest frame of a robot's camera that has arrived by this time, or NULL if no
 * frame has arrived since the last call. The frame is valid until the next call for the same
 * camera. */
const struct frob_image *frob_sim_frame(struct frob_sim *sim, size_t robot, int camera,
                                        int64_t time_ns);

/* The same functions for the world's lidars: they open a lidar on all robots, and return its name
 * and its newest scan. */
int frob_sim_open_lidar(struct frob_sim *sim, const char *lidar);
const char *frob_sim_lidar_name(const struct frob_sim *sim, size_t number);
/* The position of this lidar on its robot: ahead of the centre, and to the left. */
void frob_sim_lidar_seat(const struct frob_sim *sim, size_t number, double *ahead_m,
                         double *left_m);
const struct frob_scan *frob_sim_scan(struct frob_sim *sim, size_t robot, int lidar,
                                      int64_t time_ns);

/* The same functions for the world's inertial measurement units. A reading averages all
 * measurements that have arrived since the last call. */
int frob_sim_open_imu(struct frob_sim *sim, const char *imu);
const char *frob_sim_imu_name(const struct frob_sim *sim, size_t number);
const struct frob_imu *frob_sim_imu(struct frob_sim *sim, size_t robot, int imu, int64_t time_ns);

/* The parts of a robot's surface that currently touch an object. */
struct frob_sim_bumps {
    int left, right; /* the halves of its front; a contact in the middle counts for both */
    int back;
};

struct frob_sim_bumps frob_sim_bumps_robot(const struct frob_sim *sim, size_t robot);

/* Gives the robot the command in its output struct, which stays in effect until the next command.
 * The simulator limits the values to what the robot can do, and stops the robot if any of them is
 * NaN. `time_ns` is the time of the controller's step. */
void frob_sim_command(struct frob_sim *sim, int64_t time_ns, const void *output);
void frob_sim_command_robot(struct frob_sim *sim, size_t robot, int64_t time_ns,
                            const void *output);

/* Whether the host has lost contact with its robots at this time, according to the world's
 * [outage]. If so, the host must skip the program's step and command a stop. */
int frob_sim_is_away(const struct frob_sim *sim, int64_t time_ns);

/* The true pose of a robot in the world, and whether it touched an object during the last call to
 * frob_sim_advance that ran a step. */
struct frob_sim_place {
    double x_m, y_m, heading_rad;
    int touches;
};

struct frob_sim_place frob_sim_place_robot(const struct frob_sim *sim, size_t robot);

/* The number of movable objects, and the pose of the object with this index, counted from 0. The
 * world's boxes come first, then its balls, each in the order of the world file. `touches` is 0,
 * and a ball's heading has no meaning. */
size_t frob_sim_objects(const struct frob_sim *sim);
struct frob_sim_place frob_sim_place_object(const struct frob_sim *sim, size_t object);

/* Distance from the centre of a robot to the nearest wall, polygon, post or cone; infinite in an
 * empty world. */
double frob_sim_clearance_robot(const struct frob_sim *sim, size_t robot);

struct frob_sim_summary {
    double time_s;     /* simulated time */
    double distance_m; /* distance along the path */
    /* Number of collisions with fixed objects, boxes, balls and other robots. A collision ends
     * when the robot has not touched anything for half a second. */
    int collisions;
    double odometry_error_m; /* distance between the true position and the odometry estimate */
    int measured;            /* nonzero if the distance from a wall was measured; the next three
                                fields are valid only then */
    double wall_distance_m;  /* the distance that the robot should keep */
    double mean_error_m;     /* mean error since the robot settled; NaN if it has not settled */
    double largest_error_m;
    int tape_measured;  /* the same for the distance from the centre line of a tape */
    double mean_tape_m; /* mean distance since the robot settled; NaN if it has not settled */
    double largest_tape_m;
    double tape_way_m;      /* distance travelled along the tape, positive in the order of
                               its points */
    int ball_measured;      /* the same for the distance from a ball */
    double ball_distance_m; /* the distance that the robot should keep */
    double mean_ball_m;     /* mean error since the robot settled; NaN if it has not settled */
    double largest_ball_m;
};

struct frob_sim_summary frob_sim_summarize(const struct frob_sim *sim);
struct frob_sim_summary frob_sim_summarize_robot(const struct frob_sim *sim, size_t robot);

/* The beginning of a collision. */
struct frob_sim_collision {
    double time_s;
    double x_m, y_m;    /* place in the world */
    double clearance_m; /* result of frob_sim_clearance_robot at that time */
    /* The object, for display: "the wall (room.toml, line 12)". Valid until the next advance. */
    const char *with;
};

/* Reads the robot's collision at index `number`, counted from 0. Returns false if there is no such
 * collision. Only the first five are stored. */
int frob_sim_collision_robot(const struct frob_sim *sim, size_t robot, size_t number,
                             struct frob_sim_collision *collision);

/* Formats a collision as a summary line without a newline: "collision at 3.215 s: the wall
 * (room.toml, line 12), x 1.203 m, y 0.000 m, clearance 0.190 m". */
void frob_sim_describe_collision(const struct frob_sim_collision *collision, char *text,
                                 size_t room);

/* Draws the world, the paths of the robots, and the signals of robot 0. The file name must end
 * in .svg or .png. Returns 1, or 0 with a line in `message`. Paths and signals are drawn only if
 * `picture` was set in the settings. */
int frob_sim_picture(const struct frob_sim *sim, const char *file, char *message, size_t room);

#ifdef __cplusplus
}
#endif
#endif
