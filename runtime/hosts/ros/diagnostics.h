/* diagnostics.h -- publishes the verdicts on the program's assertions to /diagnostics. */
#ifndef FROB_HOST_ROS_DIAGNOSTICS_H
#define FROB_HOST_ROS_DIAGNOSTICS_H

#include <frob/program.h>

#include <diagnostic_msgs/msg/diagnostic_array.h>
#include <rcl/rcl.h>

#include "messages.h"

struct diagnostics {
    size_t count; /* number of the program's assertions; 0 if nothing is published */
    rcl_publisher_t publisher;
    diagnostic_msgs__msg__DiagnosticArray message;
};

/* Returns false on failure. Then `why` contains the reason, or is empty if rcl reports the
 * error. */
bool diagnostics_start(struct diagnostics *d, const struct frob_program *program,
                       const rcl_node_t *node, char *why, size_t room);

/* Stores the verdict on one assertion. After the last assertion's verdict, publishes all
 * verdicts. */
void diagnostics_take(struct diagnostics *d, const struct ros_claim *claim);

/* Returns false if rcl reports an error. */
bool diagnostics_end(struct diagnostics *d, rcl_node_t *node);

#endif
