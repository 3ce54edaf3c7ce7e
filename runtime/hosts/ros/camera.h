/* camera.h -- cameras of the robot `ros`: `--camera ros:TOPIC`.
 *
 * Each of them has its own process, which is a ROS 2 node. It writes the images of its topic as
 * PPM, PGM or JPEG to a pipe. The host reads the camera's frames from this pipe (hosts/camera), as
 * from any other pipe. Therefore images never delay the messages of the program's node. */
#ifndef FROB_HOST_ROS_CAMERA_H
#define FROB_HOST_ROS_CAMERA_H

#include <frob/program.h>

#include <stdbool.h>

/* The command line, with pipes in place of the cameras' topics. */
struct camera_sources {
    int argc;
    char **argv; /* NULL if a process could not be started */
};

/* Starts the processes for all cameras whose source is a topic. If the command line has no source
 * for any camera, the topics are `image_raw` for the camera `camera`, and `NAME/image_raw` for the
 * camera NAME. Prints a line on standard error on failure. The result is never freed. */
struct camera_sources camera_sources_of(int argc, char **argv, const struct frob_program *program);

/* If the command line starts a camera's process, runs the camera, sets `status` to its exit status,
 * and returns true. */
bool camera_is_node(int argc, char **argv, int *status);

#endif
