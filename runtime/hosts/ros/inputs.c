#include "inputs.h"

#include <stdio.h>
#include <string.h>
#include <sys/socket.h>

#include <rcl/error_handling.h>
#include <rmw/qos_profiles.h>

#include "sensors.h"

static void add(struct inputs *inputs, enum ros_kind kind, const char *name)
{
    struct input *input = &inputs->each[inputs->count++];
    input->kind = kind;
    snprintf(input->name, sizeof input->name, "%s", name);
}

bool inputs_is_sensor(const struct input *input)
{
    return input->kind == ROS_SCAN || input->kind == ROS_IMU;
}

bool inputs_of(struct inputs *inputs, const struct frob_program *program, bool use_sim_time)
{
    memset(inputs, 0, sizeof *inputs);
    add(inputs, ROS_ODOMETRY, "odom");
    if (use_sim_time)
        add(inputs, ROS_CLOCK, "/clock");
    for (size_t i = 0; i < program->control_count; i++) {
        char name[ROS_NAME];
        if (!ros_topic_of(&program->console[i], name, sizeof name) ||
            ros_first_user(program, i) < i)
            continue;
        if (inputs->count == INPUTS_MOST)
            return false;
        inputs->each[inputs->count].control = (uint32_t)i;
        add(inputs, program->console[i].kind == FROB_IMU ? ROS_IMU : ROS_SCAN, name);
    }
    return true;
}

static const rosidl_message_type_support_t *type_of(struct input *input)
{
    switch (input->kind) {
    case ROS_SCAN:
        input->topic.type = "sensor_msgs/msg/LaserScan";
        return sensor_msgs__msg__LaserScan__init(&input->message.scan)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, LaserScan)
                   : NULL;
    case ROS_IMU:
        input->topic.type = "sensor_msgs/msg/Imu";
        return sensor_msgs__msg__Imu__init(&input->message.imu)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, Imu)
                   : NULL;
    case ROS_CLOCK:
        input->topic.type = "rosgraph_msgs/msg/Clock";
        return rosgraph_msgs__msg__Clock__init(&input->message.clock)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(rosgraph_msgs, msg, Clock)
                   : NULL;
    default:
        input->topic.type = "nav_msgs/msg/Odometry";
        return nav_msgs__msg__Odometry__init(&input->message.odometry)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(nav_msgs, msg, Odometry)
                   : NULL;
    }
}

const char *inputs_subscribe(struct inputs *inputs, const rcl_node_t *node)
{
    rcl_subscription_options_t options = rcl_subscription_get_default_options();
    /* Best-effort delivery matches every publisher. */
    options.qos = rmw_qos_profile_sensor_data;
    for (size_t i = 0; i < inputs->count; i++) {
        struct input *input = &inputs->each[i];
        const rosidl_message_type_support_t *type = type_of(input);
        input->subscription = rcl_get_zero_initialized_subscription();
        if (type == NULL || rcl_subscription_init(&input->subscription, node, type, input->name,
                                                  &options) != RCL_RET_OK)
            return input->name;
        input->topic.name = rcl_subscription_get_topic_name(&input->subscription);
    }
    return NULL;
}

static int64_t to_ns(const builtin_interfaces__msg__Time *time)
{
    return (int64_t)time->sec * 1000000000 + (int64_t)time->nanosec;
}

static int64_t stamp_of(const std_msgs__msg__Header *header)
{
    return to_ns(&header->stamp);
}

static void send_message(int socket, const struct ros_head *message)
{
    /* The message may be dropped. */
    ssize_t sent = send(socket, message, message->size, MSG_NOSIGNAL | MSG_DONTWAIT);
    (void)sent;
}

static struct ros_head head(enum ros_kind kind, size_t size)
{
    const struct ros_head head = { (uint32_t)size, (uint32_t)kind };
    return head;
}

static struct ros_origin origin(const struct input *input, const std_msgs__msg__Header *header)
{
    const struct ros_origin origin = { input->control, stamp_of(header), node_now_ns() };
    return origin;
}

static void send_odometry(const nav_msgs__msg__Odometry *m, int socket)
{
    struct ros_odometry o;
    memset(&o, 0, sizeof o);
    o.head = head(ROS_ODOMETRY, sizeof o);
    o.arrived_ns = node_now_ns();
    o.stamp_ns = stamp_of(&m->header);
    o.x_m = m->pose.pose.position.x;
    o.y_m = m->pose.pose.position.y;
    o.rotation[0] = m->pose.pose.orientation.x;
    o.rotation[1] = m->pose.pose.orientation.y;
    o.rotation[2] = m->pose.pose.orientation.z;
    o.rotation[3] = m->pose.pose.orientation.w;
    o.speed_m_s = m->twist.twist.linear.x;
    o.turning_rad_s = m->twist.twist.angular.z;
    send_message(socket, &o.head);
}

static void send_scan(struct inputs *inputs, const struct input *input, int socket)
{
    const sensor_msgs__msg__LaserScan *m = &input->message.scan;
    struct ros_scan *scan = &inputs->scan;
    if (m->ranges.size > ROS_RAYS_MOST) {
        fprintf(stderr, "warning: a message on %s is ignored: it has more than %d ranges\n",
                input->topic.name, ROS_RAYS_MOST);
        return;
    }
    scan->head = head(ROS_SCAN, offsetof(struct ros_scan, ranges_m) +
                                    m->ranges.size * sizeof *scan->ranges_m);
    scan->origin = origin(input, &m->header);
    scan->first_rad = (double)m->angle_min;
    scan->step_rad = (double)m->angle_increment;
    scan->nearest_m = (double)m->range_min;
    scan->farthest_m = (double)m->range_max;
    scan->count = (uint32_t)m->ranges.size;
    if (m->ranges.size > 0)
        memcpy(scan->ranges_m, m->ranges.data, m->ranges.size * sizeof *scan->ranges_m);
    send_message(socket, &scan->head);
}

static void send_imu(const struct input *input, int socket)
{
    const sensor_msgs__msg__Imu *m = &input->message.imu;
    struct ros_imu imu;
    memset(&imu, 0, sizeof imu);
    imu.head = head(ROS_IMU, sizeof imu);
    imu.origin = origin(input, &m->header);
    imu.rate_radps[0] = m->angular_velocity.x;
    imu.rate_radps[1] = m->angular_velocity.y;
    imu.rate_radps[2] = m->angular_velocity.z;
    imu.acceleration_mps2[0] = m->linear_acceleration.x;
    imu.acceleration_mps2[1] = m->linear_acceleration.y;
    imu.acceleration_mps2[2] = m->linear_acceleration.z;
    imu.rotation[0] = m->orientation.x;
    imu.rotation[1] = m->orientation.y;
    imu.rotation[2] = m->orientation.z;
    imu.rotation[3] = m->orientation.w;
    /* By the message's definition, -1 means that there is no orientation. */
    imu.has_rotation = m->orientation_covariance[0] != -1.0;
    send_message(socket, &imu.head);
}

static void send_clock(struct inputs *inputs, const struct input *input, int socket)
{
    struct ros_clock clock;
    memset(&clock, 0, sizeof clock);
    clock.head = head(ROS_CLOCK, sizeof clock);
    clock.time_ns = to_ns(&input->message.clock.clock);
    __atomic_store_n(&inputs->clock_ns, clock.time_ns, __ATOMIC_SEQ_CST);
    send_message(socket, &clock.head);
}

void inputs_take(struct inputs *inputs, struct input *input, int socket)
{
    while (rcl_take(&input->subscription, &input->message, NULL, NULL) == RCL_RET_OK) {
        input->heard = true;
        switch (input->kind) {
        case ROS_SCAN: send_scan(inputs, input, socket); break;
        case ROS_IMU: send_imu(input, socket); break;
        case ROS_CLOCK: send_clock(inputs, input, socket); break;
        default: send_odometry(&input->message.odometry, socket); break;
        }
    }
    rcl_reset_error(); /* there are no more messages */
}
