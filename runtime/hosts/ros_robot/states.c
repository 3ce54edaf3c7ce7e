#include "states.h"

#include <math.h>

#include <rcl/error_handling.h>
#include <std_msgs/msg/bool.h>

static const char *const topics[ROS_BUMPERS] = { "bumper_left", "bumper_right", "bumper_back" };

static bool advertise(rcl_publisher_t *publisher, const rcl_node_t *node,
                      const rosidl_message_type_support_t *type, const char *topic)
{
    const rcl_publisher_options_t options = rcl_publisher_get_default_options();
    *publisher = rcl_get_zero_initialized_publisher();
    return rcl_publisher_init(publisher, node, type, topic, &options) == RCL_RET_OK;
}

const char *states_start(struct states *s, const rcl_node_t *node)
{
    for (size_t i = 0; i < ROS_BUMPERS; i++)
        if (!advertise(&s->bumpers[i], node, ROSIDL_GET_MSG_TYPE_SUPPORT(std_msgs, msg, Bool),
                       topics[i]))
            return topics[i];
    if (!sensor_msgs__msg__BatteryState__init(&s->message) ||
        !advertise(&s->battery, node, ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, BatteryState),
                   "battery_state"))
        return "battery_state";
    /* According to the message's definition, NaN means that the value is not
     * measured. */
    s->message.current = s->message.charge = s->message.capacity = s->message.design_capacity =
        s->message.percentage = s->message.temperature = NAN;
    s->message.present = true;
    return NULL;
}

void states_publish(struct states *s, const struct ros_states *states)
{
    for (size_t i = 0; i < ROS_BUMPERS; i++) {
        std_msgs__msg__Bool message;
        message.data = states->pressed[i];
        if (rcl_publish(&s->bumpers[i], &message, NULL) != RCL_RET_OK)
            rcl_reset_error();
    }
    s->message.header.stamp.sec = (int32_t)(states->stamp_ns / 1000000000);
    s->message.header.stamp.nanosec = (uint32_t)(states->stamp_ns % 1000000000);
    s->message.voltage = (float)states->battery_v;
    if (rcl_publish(&s->battery, &s->message, NULL) != RCL_RET_OK)
        rcl_reset_error();
}

bool states_end(struct states *s, rcl_node_t *node)
{
    bool ok = rcl_publisher_fini(&s->battery, node) == RCL_RET_OK;
    for (size_t i = 0; i < ROS_BUMPERS; i++)
        ok = rcl_publisher_fini(&s->bumpers[i], node) == RCL_RET_OK && ok;
    return ok;
}
