#include "outputs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <rcl/error_handling.h>
#include <rosidl_runtime_c/string_functions.h>

/* Queue depth of a topic that is an event, in messages. */
enum { EVENTS_KEPT = 10 };

/* ---- Setting up */

static bool lacks_memory(char *why, size_t room)
{
    snprintf(why, room, "not enough memory");
    return false;
}

static bool advertise(struct outputs *o, size_t i, const rosidl_message_type_support_t *support,
                      const char *name, size_t depth, const rcl_node_t *node, char *why,
                      size_t room)
{
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    options.qos.depth = depth;
    o->publishers[i] = rcl_get_zero_initialized_publisher();
    if (rcl_publisher_init(&o->publishers[i], node, support, name, &options) != RCL_RET_OK) {
        snprintf(why, room, "cannot publish %s:", name);
        return false;
    }
    o->topics[i].name = rcl_publisher_get_topic_name(&o->publishers[i]);
    o->count = i + 1;
    return true;
}

static bool start_velocity(struct outputs *o, const rcl_node_t *node, char *why, size_t room)
{
    const rosidl_message_type_support_t *type =
        o->stamped ? ROSIDL_GET_MSG_TYPE_SUPPORT(geometry_msgs, msg, TwistStamped)
                   : ROSIDL_GET_MSG_TYPE_SUPPORT(geometry_msgs, msg, Twist);
    o->topics[0].type = o->stamped ? "geometry_msgs/msg/TwistStamped" : "geometry_msgs/msg/Twist";
    o->topics[0].kept = "old velocities";
    o->topics[0].cure = "; add `--set stamped=1`";
    if (!geometry_msgs__msg__Twist__init(&o->twist) ||
        !geometry_msgs__msg__TwistStamped__init(&o->stamped_twist) ||
        !rosidl_runtime_c__String__assign(&o->stamped_twist.header.frame_id, "base_link"))
        return lacks_memory(why, room);
    /* Old velocities are useless. */
    return advertise(o, 0, type, "cmd_vel", 1, node, why, room);
}

/* Returns the frame for a message whose frame the program omits: the odometry frame for poses and
 * markers, the robot's frame for everything else. */
static const char *frame_of(const char *type)
{
    static const char *const in_odometry[] = {
        "nav_msgs/msg/Odometry",
        "nav_msgs/msg/Path",
        "geometry_msgs/msg/PoseStamped",
        "geometry_msgs/msg/PoseArray",
        "geometry_msgs/msg/PoseWithCovarianceStamped",
        "visualization_msgs/msg/Marker",
        "visualization_msgs/msg/MarkerArray",
    };
    for (size_t i = 0; i < sizeof in_odometry / sizeof in_odometry[0]; i++)
        if (strcmp(type, in_odometry[i]) == 0)
            return "odom";
    return "base_link";
}

static bool set_frame(const struct message_type *type, void *message)
{
    std_msgs__msg__Header *header = (std_msgs__msg__Header *)message_header(type, message);
    return header == NULL ||
           rosidl_runtime_c__String__assign(&header->frame_id, frame_of(type->name));
}

static bool start_own(struct outputs *o, size_t i, const rcl_node_t *node, char *why, size_t room)
{
    struct own_output *own = &o->own[i];
    own->topic = &o->program->node->outputs[i];
    own->parts = topic_parts_of(o->program->output, own->topic);
    if (!message_type_find(&own->type, own->topic->type, why, room) ||
        !mapping_of(&own->mapping, &own->type, own->parts.message, o->program->node, why, room))
        return false;
    own->message = message_create(&own->type);
    own->zero = message_create(&own->type);
    if (own->message == NULL || own->zero == NULL || !set_frame(&own->type, own->zero))
        return lacks_memory(why, room);
    o->topics[i].type = own->topic->type;
    o->topics[i].kept = "earlier messages";
    o->topics[i].cure = "; declare the field as a TwistStamped";
    return advertise(o, i, own->type.support, own->topic->name,
                     own->parts.event == NULL ? 1 : EVENTS_KEPT, node, why, room);
}

bool outputs_start(struct outputs *o, const struct frob_program *program, bool stamped,
                   const rcl_node_t *node, char *why, size_t room)
{
    const size_t count = program->node != NULL ? program->node->output_count : 1;
    memset(o, 0, sizeof *o);
    o->program = program;
    o->stamped = stamped;
    o->publishers = (rcl_publisher_t *)calloc(count + 1, sizeof *o->publishers);
    o->topics = (struct topic *)calloc(count + 1, sizeof *o->topics);
    o->own = (struct own_output *)calloc(count + 1, sizeof *o->own);
    if (o->publishers == NULL || o->topics == NULL || o->own == NULL)
        return lacks_memory(why, room);
    if (program->node == NULL)
        return start_velocity(o, node, why, room);
    if (topic_span_of(program->output).end > ROS_VALUE_MOST) {
        snprintf(why, room, "the output of the program has %zu bytes, more than the maximum of %d",
                 topic_span_of(program->output).end, ROS_VALUE_MOST);
        return false;
    }
    for (size_t i = 0; i < count; i++)
        if (!start_own(o, i, node, why, room))
            return false;
    return true;
}

/* ---- Publishing */

static void set_stamp(builtin_interfaces__msg__Time *stamp)
{
    const int64_t now_ns = node_stamp_ns();
    stamp->sec = (int32_t)(now_ns / 1000000000);
    stamp->nanosec = (uint32_t)(now_ns % 1000000000);
}

static void publish(struct outputs *o, size_t i, const void *message)
{
    if (rcl_publish(&o->publishers[i], message, NULL) == RCL_RET_OK)
        return;
    fprintf(stderr, "error: cannot publish %s: %s\n", o->topics[i].name,
            rcl_get_error_string().str);
    rcl_reset_error();
}

void outputs_drive(struct outputs *o, double speed_m_s, double turn_rad_s)
{
    o->twist.linear.x = speed_m_s;
    o->twist.angular.z = turn_rad_s;
    if (o->stamped) {
        set_stamp(&o->stamped_twist.header.stamp);
        o->stamped_twist.twist = o->twist;
    }
    publish(o, 0, o->stamped ? (const void *)&o->stamped_twist : &o->twist);
}

static void publish_zero(struct outputs *o, size_t i)
{
    void *zero = o->own[i].zero;
    std_msgs__msg__Header *header = (std_msgs__msg__Header *)message_header(&o->own[i].type, zero);
    if (header != NULL)
        set_stamp(&header->stamp);
    publish(o, i, zero);
}

/* A command is sent only if all its numbers are finite. */
static bool is_sound(struct own_output *own, const void *values)
{
    if (!own->topic->is_command || mapping_is_finite(&own->mapping, values))
        return true;
    if (!own->told)
        fprintf(stderr,
                "warning: `%s` has a number that is not finite; zero is published instead\n",
                own->topic->field);
    own->told = true;
    return false;
}

void outputs_publish(struct outputs *o, const void *values, bool rests)
{
    for (size_t i = 0; i < o->count; i++) {
        struct own_output *own = &o->own[i];
        const struct message_origin origin = { node_stamp_ns(), frame_of(own->type.name) };
        const struct frob_value *event = own->parts.event;
        if (event != NULL && ((const char *)values)[event->offset] == 0)
            continue;
        if ((own->topic->is_command && rests) || !is_sound(own, values))
            publish_zero(o, i);
        else if (mapping_write(&own->mapping, values, &origin, own->message))
            publish(o, i, own->message);
    }
}

void outputs_rest(struct outputs *o)
{
    if (o->program->node == NULL) {
        outputs_drive(o, 0.0, 0.0);
        return;
    }
    for (size_t i = 0; i < o->count; i++)
        if (o->own[i].topic->is_command)
            publish_zero(o, i);
}

void outputs_wait(const struct outputs *o, int64_t most_ns)
{
    for (size_t i = 0; i < o->count; i++)
        if (o->program->node == NULL || o->own[i].topic->is_command)
            if (rcl_publisher_wait_for_all_acked(&o->publishers[i], most_ns) != RCL_RET_OK)
                rcl_reset_error();
}

bool outputs_end(struct outputs *o, rcl_node_t *node)
{
    bool ok = true;
    for (size_t i = 0; i < o->count; i++)
        ok = rcl_publisher_fini(&o->publishers[i], node) == RCL_RET_OK && ok;
    return ok;
}
