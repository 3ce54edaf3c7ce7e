/* camera.h -- cameras of the robot `ros`: `--camera ros:TOPIC`.
 *
 * For each of them, one more process is a ROS 2 node, which writes the images of its topic to a
 * pipe as PPM, PGM or JPEG. This pipe is the source of the camera's frames (hosts/camera), like any
 * other pipe. Therefore images never delay the messages of the program's node. */
#ifndef FROB_HOST_ROS_CAMERA_H
#define FROB_HOST_ROS_CAMERA_H

#include <frob/program.h>

#include <stdbool.h>

/* The command line, in which pipes replace the topics of cameras. */
struct camera_sources {
    int argc;
    char **argv; /* NULL if a process could not be started */
};

/* Starts the processes for all cameras whose source is a topic. If the command line has no source
 * for any camera, these are the topics `image_raw` for the camera `camera`, and `NAME/image_raw` for
 * others. Prints a line on standard error on failure. The result is never freed. */
struct camera_sources camera_sources_of(int argc, char **argv, const struct frob_program *program);

/* If the command line is that of a camera's process, runs it, and returns true and its exit
 * status. */
bool camera_is_node(int argc, char **argv, int *status);

#endif
