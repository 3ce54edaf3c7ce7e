/* acceptance.h -- decides which messages from the node to accept: rejects late ones, and those with
 * implausible timestamps or numbers. */
#ifndef FROB_HOST_ROS_ACCEPTANCE_H
#define FROB_HOST_ROS_ACCEPTANCE_H

#include <stdbool.h>
#include <stdint.h>

struct ros_device;
struct ros_topic;

/* Decides whether to accept a message. Reports rejected messages, once for each reason. `bad`: the
 * reason why the message's content is invalid, or NULL. For an accepted message, stores in
 * `taken_ns` the time on our clock at which it was sent. */
bool ros_accepts(struct ros_device *device, struct ros_topic *topic, const char *bad,
                 int64_t stamp_ns, int64_t arrived_ns, int64_t *taken_ns);

/* Reports that messages no longer arrive. Repeats this only after another message has arrived. */
void ros_tell_silence(const struct ros_device *device, struct ros_topic *topic, const char *effect);

/* Returns whether the timestamps of messages are based on /clock. */
bool ros_has_sim_time(const struct ros_device *device);

#endif
