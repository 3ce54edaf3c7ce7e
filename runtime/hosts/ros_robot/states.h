/* states.h -- publishes the simulated robot's bumpers (std_msgs/msg/Bool on bumper_left,
 * bumper_right and bumper_back) and its battery (battery_state). */
#ifndef FROB_HOST_ROS_ROBOT_STATES_H
#define FROB_HOST_ROS_ROBOT_STATES_H

#include <rcl/rcl.h>
#include <sensor_msgs/msg/battery_state.h>

#include <stdbool.h>

#include "hosts/ros/messages.h"

struct states {
    rcl_publisher_t bumpers[ROS_BUMPERS];
    rcl_publisher_t battery;
    sensor_msgs__msg__BatteryState message;
};

/* Returns NULL, or the name of a topic that rcl rejects. */
const char *states_start(struct states *s, const rcl_node_t *node);

void states_publish(struct states *s, const struct ros_states *states);

/* Returns false if rcl reports an error. */
bool states_end(struct states *s, rcl_node_t *node);

#endif
