/* markers.h -- publishes the program's drawing on ~/markers, in the odometry and robot frames. */
#ifndef FROB_HOST_ROS_MARKERS_H
#define FROB_HOST_ROS_MARKERS_H

#include <frob/program.h>

#include <rcl/rcl.h>
#include <visualization_msgs/msg/marker_array.h>

#include "messages.h"
#include "tf.h"

struct markers {
    const struct frob_value *drawing; /* NULL if nothing is published */
    char *output;                     /* the program's output, of which only the drawing is set */
    size_t room;                      /* maximum number of markers */
    size_t shown;                     /* number of markers in the last message */
    rcl_publisher_t publisher;
    visualization_msgs__msg__MarkerArray message;
};

/* Creates the publisher of the markers. On failure, returns false and explains why in `why`, which
 * is empty if rcl reports an error. */
bool markers_start(struct markers *m, const struct frob_program *program, const rcl_node_t *node,
                   char *why, size_t room);

/* Publishes a drawing if the topic has a subscriber. */
void markers_take(struct markers *m, const struct ros_marks *marks, const struct tf *tf);

/* Removes all markers. Returns false if rcl reports an error. */
bool markers_end(struct markers *m, rcl_node_t *node);

#endif
