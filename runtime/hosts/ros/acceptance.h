/* acceptance.h -- which messages of the node count: not those that are late, or whose stamps or
 * numbers are implausible. */
#ifndef FROB_HOST_ROS_ACCEPTANCE_H
#define FROB_HOST_ROS_ACCEPTANCE_H

#include <stdbool.h>
#include <stdint.h>

struct ros_device;
struct ros_topic;

/* Decides whether to accept a message. Reports rejected messages, once for each reason. `bad`: the
 * reason why its content is invalid, or NULL. Stores the time at which it was sent, on our clock,
 * in `taken_ns`. */
bool ros_accepts(struct ros_device *device, struct ros_topic *topic, const char *bad,
                 int64_t stamp_ns, int64_t arrived_ns, int64_t *taken_ns);

/* Reports once that messages no longer arrive, until the next one does. */
void ros_tell_silence(const struct ros_device *device, struct ros_topic *topic, const char *effect);

/* Whether the time of messages is that of /clock. */
bool ros_has_sim_time(const struct ros_device *device);

#endif
