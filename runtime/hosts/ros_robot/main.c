/* The ROS 2 node of a simulated robot. `frobc serve --robot ros` compiles it, and the simulator
 * (sim/serve/ros_robot.cc) starts it:
 *
 *   robot SOCKET [stamped] [SENSOR=TOPIC,X,Y]... [camera=TOPIC,NAME,DESCRIPTOR]...
 *     -- [ARGUMENT FOR ROS]...
 *
 * SENSOR is `scan` or `imu`, and (X, Y) is its position on the robot in metres.
 *
 * The simulator sends the robot's sensor values over the socket as the messages of
 * hosts/ros/messages.h, and the node publishes them. In a sensor's message, `control` is the
 * sensor's number on the command line. The node sends back the velocities of cmd_vel. It ends when
 * the simulator closes the socket. */
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <geometry_msgs/msg/twist.h>
#include <geometry_msgs/msg/twist_stamped.h>
#include <nav_msgs/msg/odometry.h>
#include <rcl/error_handling.h>
#include <rcl/graph.h>
#include <rcl/rcl.h>
#include <rmw/qos_profiles.h>
#include <rosgraph_msgs/msg/clock.h>
#include <rosidl_runtime_c/primitives_sequence_functions.h>
#include <rosidl_runtime_c/string_functions.h>
#include <sensor_msgs/msg/imu.h>
#include <sensor_msgs/msg/laser_scan.h>

#include "hosts/ros/messages.h"

#include "images.h"
#include "states.h"
#include "transforms.h"

#define CHECK_NS INT64_C(1000000000)

enum { DONE = 0, FAULT = 2 };

struct sensor {
    enum ros_kind kind;
    char topic[ROS_NAME];
    rcl_publisher_t publisher;
};

/* The messages from the simulator. */
union message {
    struct ros_head head;
    struct ros_odometry odometry;
    struct ros_scan scan;
    struct ros_imu imu;
    struct ros_clock clock;
    struct ros_states states;
    struct ros_image image;
};

struct robot {
    int socket;
    bool stamped; /* whether cmd_vel is of type TwistStamped */
    struct sensor sensors[ROS_SENSORS_MOST];
    size_t sensor_count;
    struct seat seats[ROS_SENSORS_MOST]; /* the positions of the sensors */
    struct transforms transforms;
    struct states states;
    struct images images;
    rcl_context_t context;
    rcl_node_t node;
    rcl_publisher_t odometry, clock;
    rcl_subscription_t velocity;
    rcl_guard_condition_t over; /* triggered when the simulator has closed the socket */
    bool is_over;               /* accessed atomically */
    bool told_type;
    union message received;
    nav_msgs__msg__Odometry odometry_message;
    sensor_msgs__msg__LaserScan scan_message;
    sensor_msgs__msg__Imu imu_message;
    rosgraph_msgs__msg__Clock clock_message;
    geometry_msgs__msg__Twist twist;
    geometry_msgs__msg__TwistStamped twist_stamped;
};

/* Tells the simulator why the node cannot start. */
static bool refuse(const struct robot *r, const char *what)
{
    struct ros_refused refused;
    memset(&refused, 0, sizeof refused);
    refused.head.size = (uint32_t)sizeof refused;
    refused.head.kind = ROS_REFUSED;
    snprintf(refused.reason, sizeof refused.reason, "%s: %s", what, rcl_get_error_string().str);
    if (send(r->socket, &refused, sizeof refused, MSG_NOSIGNAL) < 0)
        fprintf(stderr, "error: %s\n", refused.reason);
    return false;
}

/* ---- Joining the ROS 2 system */

static bool join(struct robot *r, int argc, char **argv)
{
    rcl_allocator_t allocator = rcl_get_default_allocator();
    rcl_init_options_t init = rcl_get_zero_initialized_init_options();
    rcl_node_options_t options = rcl_node_get_default_options();
    rcl_ret_t result;
    if (rcl_init_options_init(&init, allocator) != RCL_RET_OK)
        return refuse(r, "cannot initialize ROS 2");
    r->context = rcl_get_zero_initialized_context();
    result = rcl_init(argc, (char const *const *)argv, &init, &r->context);
    if (rcl_init_options_fini(&init) != RCL_RET_OK)
        rcl_reset_error();
    if (result != RCL_RET_OK)
        return refuse(r, result == RCL_RET_INVALID_ROS_ARGS ? "invalid argument after --ros-args"
                                                            : "cannot initialize ROS 2");
    r->node = rcl_get_zero_initialized_node();
    if (rcl_node_init(&r->node, "robot", "", &r->context, &options) != RCL_RET_OK)
        return refuse(r, "cannot create the node");
    return true;
}

/* Reliable publishers are compatible with every subscription. */
static bool advertise(struct robot *r, rcl_publisher_t *publisher, const char *topic, size_t depth,
                      const rosidl_message_type_support_t *type)
{
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    char what[ROS_NAME + 32];
    options.qos.depth = depth;
    *publisher = rcl_get_zero_initialized_publisher();
    if (rcl_publisher_init(publisher, &r->node, type, topic, &options) == RCL_RET_OK)
        return true;
    snprintf(what, sizeof what, "cannot publish %s", topic);
    return refuse(r, what);
}

static bool prepare_messages(struct robot *r)
{
    return nav_msgs__msg__Odometry__init(&r->odometry_message) &&
           sensor_msgs__msg__LaserScan__init(&r->scan_message) &&
           sensor_msgs__msg__Imu__init(&r->imu_message) &&
           rosgraph_msgs__msg__Clock__init(&r->clock_message) &&
           geometry_msgs__msg__Twist__init(&r->twist) &&
           geometry_msgs__msg__TwistStamped__init(&r->twist_stamped) &&
           rosidl_runtime_c__String__assign(&r->odometry_message.header.frame_id, "odom") &&
           rosidl_runtime_c__String__assign(&r->odometry_message.child_frame_id, "base_link");
}

static bool open_topics(struct robot *r)
{
    rcl_subscription_options_t options = rcl_subscription_get_default_options();
    const char *failed;
    bool ok = prepare_messages(r) || refuse(r, "not enough memory");
    ok = ok && advertise(r, &r->odometry, "odom", 10,
                         ROSIDL_GET_MSG_TYPE_SUPPORT(nav_msgs, msg, Odometry));
    ok = ok && advertise(r, &r->clock, "/clock", 1,
                         ROSIDL_GET_MSG_TYPE_SUPPORT(rosgraph_msgs, msg, Clock));
    for (size_t i = 0; ok && i < r->sensor_count; i++) {
        const bool is_scan = r->sensors[i].kind == ROS_SCAN;
        ok = advertise(r, &r->sensors[i].publisher, r->sensors[i].topic, 5,
                       is_scan ? ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, LaserScan)
                               : ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, Imu));
    }
    if (!ok)
        return false;
    failed = states_start(&r->states, &r->node);
    if (failed == NULL)
        failed = images_start(&r->images, &r->node);
    if (failed != NULL) {
        char what[ROS_NAME + 32];
        snprintf(what, sizeof what, "cannot publish %s", failed);
        return refuse(r, what);
    }
    /* Best-effort delivery is compatible with every publisher. */
    options.qos = rmw_qos_profile_sensor_data;
    r->velocity = rcl_get_zero_initialized_subscription();
    if (rcl_subscription_init(&r->velocity, &r->node,
                              r->stamped
                                  ? ROSIDL_GET_MSG_TYPE_SUPPORT(geometry_msgs, msg, TwistStamped)
                                  : ROSIDL_GET_MSG_TYPE_SUPPORT(geometry_msgs, msg, Twist),
                              "cmd_vel", &options) != RCL_RET_OK)
        return refuse(r, "cannot subscribe to cmd_vel");
    r->over = rcl_get_zero_initialized_guard_condition();
    if (rcl_guard_condition_init(&r->over, &r->context,
                                 rcl_guard_condition_get_default_options()) != RCL_RET_OK)
        return refuse(r, "cannot initialize ROS 2");
    return true;
}

static builtin_interfaces__msg__Time time_of(int64_t ns)
{
    builtin_interfaces__msg__Time time;
    time.sec = (int32_t)(ns / 1000000000);
    time.nanosec = (uint32_t)(ns % 1000000000);
    return time;
}

static bool start_transforms(struct robot *r)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (!transforms_start(&r->transforms, &r->node, r->seats, r->sensor_count,
                          time_of((int64_t)now.tv_sec * 1000000000 + now.tv_nsec)))
        return refuse(r, "cannot publish /tf");
    if (!r->transforms.has_type)
        fprintf(
            stderr,
            "warning: the simulated robot does not publish /tf, because the package tf2_msgs is "
            "not installed\n");
    return true;
}

/* Tells the simulator the names of the node and its topics, after remapping. */
static bool report(const struct robot *r)
{
    struct ros_started started;
    memset(&started, 0, sizeof started);
    started.head.size = (uint32_t)sizeof started;
    started.head.kind = ROS_STARTED;
    snprintf(started.node, sizeof started.node, "%s", rcl_node_get_fully_qualified_name(&r->node));
    snprintf(started.odometry, sizeof started.odometry, "%s",
             rcl_publisher_get_topic_name(&r->odometry));
    snprintf(started.velocity, sizeof started.velocity, "%s",
             rcl_subscription_get_topic_name(&r->velocity));
    started.sensor_count = (uint32_t)r->sensor_count;
    for (size_t i = 0; i < r->sensor_count; i++) {
        started.sensors[i].control = (uint32_t)i;
        snprintf(started.sensors[i].topic, sizeof started.sensors[i].topic, "%s",
                 rcl_publisher_get_topic_name(&r->sensors[i].publisher));
    }
    return send(r->socket, &started, sizeof started, MSG_NOSIGNAL) >= 0;
}

/* ---- Publishing */

static void publish(const rcl_publisher_t *publisher, const void *message)
{
    if (rcl_publish(publisher, message, NULL) != RCL_RET_OK)
        rcl_reset_error();
}

/* Sets the frame of a sensor's message. Without transforms, it is the robot's frame, which every
 * node knows. */
static bool set_frame(const struct robot *r, std_msgs__msg__Header *header, uint32_t sensor)
{
    return rosidl_runtime_c__String__assign(
        &header->frame_id, r->transforms.has_type ? r->seats[sensor].frame : "base_link");
}

static void publish_odometry(struct robot *r, const struct ros_odometry *o)
{
    nav_msgs__msg__Odometry *m = &r->odometry_message;
    m->header.stamp = time_of(o->stamp_ns);
    m->pose.pose.position.x = o->x_m;
    m->pose.pose.position.y = o->y_m;
    m->pose.pose.orientation.z = o->rotation[2];
    m->pose.pose.orientation.w = o->rotation[3];
    m->twist.twist.linear.x = o->speed_m_s;
    m->twist.twist.angular.z = o->turning_rad_s;
    publish(&r->odometry, m);
    transforms_publish(&r->transforms, m);
}

static void publish_scan(struct robot *r, const struct ros_scan *scan)
{
    sensor_msgs__msg__LaserScan *m = &r->scan_message;
    m->header.stamp = time_of(scan->origin.stamp_ns);
    m->angle_min = (float)scan->first_rad;
    m->angle_increment = (float)scan->step_rad;
    m->angle_max = (float)(scan->first_rad + scan->step_rad * (scan->count - 1));
    m->range_min = (float)scan->nearest_m;
    m->range_max = (float)scan->farthest_m;
    if (m->ranges.size != scan->count) {
        rosidl_runtime_c__float__Sequence__fini(&m->ranges);
        if (!rosidl_runtime_c__float__Sequence__init(&m->ranges, scan->count))
            return;
    }
    memcpy(m->ranges.data, scan->ranges_m, scan->count * sizeof *scan->ranges_m);
    if (set_frame(r, &m->header, scan->origin.control))
        publish(&r->sensors[scan->origin.control].publisher, m);
}

static void publish_imu(struct robot *r, const struct ros_imu *imu)
{
    sensor_msgs__msg__Imu *m = &r->imu_message;
    m->header.stamp = time_of(imu->origin.stamp_ns);
    m->angular_velocity.x = imu->rate_radps[0];
    m->angular_velocity.y = imu->rate_radps[1];
    m->angular_velocity.z = imu->rate_radps[2];
    m->linear_acceleration.x = imu->acceleration_mps2[0];
    m->linear_acceleration.y = imu->acceleration_mps2[1];
    m->linear_acceleration.z = imu->acceleration_mps2[2];
    m->orientation.z = imu->rotation[2];
    m->orientation.w = imu->rotation[3];
    /* According to the message's definition, -1 means that there is no orientation. */
    m->orientation_covariance[0] = imu->has_rotation ? 0.0 : -1.0;
    if (set_frame(r, &m->header, imu->origin.control))
        publish(&r->sensors[imu->origin.control].publisher, m);
}

/* The thread that publishes. It ends when the simulator closes the socket. */
static void *publish_all(void *of)
{
    struct robot *r = (struct robot *)of;
    for (;;) {
        const union message *m = &r->received;
        ssize_t got = recv(r->socket, &r->received, sizeof r->received, 0);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < (ssize_t)sizeof m->head || got != (ssize_t)m->head.size)
            break;
        switch (m->head.kind) {
        case ROS_ODOMETRY: publish_odometry(r, &m->odometry); break;
        case ROS_SCAN: publish_scan(r, &m->scan); break;
        case ROS_IMU: publish_imu(r, &m->imu); break;
        case ROS_IMAGE: images_publish(&r->images, &m->image); break;
        case ROS_STATES: states_publish(&r->states, &m->states); break;
        case ROS_CLOCK:
            r->clock_message.clock = time_of(m->clock.time_ns);
            publish(&r->clock, &r->clock_message);
            break;
        default: break;
        }
    }
    __atomic_store_n(&r->is_over, true, __ATOMIC_SEQ_CST);
    if (rcl_trigger_guard_condition(&r->over) != RCL_RET_OK)
        rcl_reset_error();
    return NULL;
}

/* ---- Velocities */

/* Sends the newest velocity to the simulator. */
static void take_velocity(struct robot *r)
{
    void *message = r->stamped ? (void *)&r->twist_stamped : (void *)&r->twist;
    struct ros_velocity velocity;
    bool has_one = false;
    while (rcl_take(&r->velocity, message, NULL, NULL) == RCL_RET_OK)
        has_one = true;
    rcl_reset_error(); /* there are no more messages */
    if (!has_one)
        return;
    if (r->stamped)
        r->twist = r->twist_stamped.twist;
    memset(&velocity, 0, sizeof velocity);
    velocity.head.size = (uint32_t)sizeof velocity;
    velocity.head.kind = ROS_VELOCITY;
    velocity.speed_m_s = r->twist.linear.x;
    velocity.turn_rad_s = r->twist.angular.z;
    if (send(r->socket, &velocity, sizeof velocity, MSG_NOSIGNAL | MSG_DONTWAIT) < 0)
        return; /* the next velocity replaces this one */
}

/* Warns once if another node publishes velocities of the wrong type, which this node cannot
 * receive. */
static void look_at_type(struct robot *r)
{
    rcutils_allocator_t allocator = rcutils_get_default_allocator();
    rcl_topic_endpoint_info_array_t nodes = rcl_get_zero_initialized_topic_endpoint_info_array();
    const char *topic = rcl_subscription_get_topic_name(&r->velocity);
    const char *type = r->stamped ? "geometry_msgs/msg/TwistStamped" : "geometry_msgs/msg/Twist";
    if (r->told_type || rcl_get_publishers_info_by_topic(&r->node, &allocator, topic, false,
                                                         &nodes) != RCL_RET_OK) {
        rcl_reset_error();
        return;
    }
    for (size_t i = 0; i < nodes.size && !r->told_type; i++) {
        const rcl_topic_endpoint_info_t *other = &nodes.info_array[i];
        if (strcmp(other->topic_type, type) == 0)
            continue;
        r->told_type = true;
        fprintf(stderr,
                "warning: the node %s publishes %s on %s, but the simulated robot needs %s: %s\n",
                other->node_name, other->topic_type, topic, type,
                r->stamped ? "remove --stamped" : "add --stamped");
    }
    if (rcl_topic_endpoint_info_array_fini(&nodes, &allocator) != RCL_RET_OK)
        rcl_reset_error();
}

static int64_t now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

static int listen_until_over(struct robot *r)
{
    rcl_wait_set_t set = rcl_get_zero_initialized_wait_set();
    int64_t checked_ns = now_ns();
    if (rcl_wait_set_init(&set, 1, 1, 0, 0, 0, 0, &r->context, rcl_get_default_allocator()) !=
        RCL_RET_OK) {
        fprintf(stderr, "error: %s\n", rcl_get_error_string().str);
        return FAULT;
    }
    while (!__atomic_load_n(&r->is_over, __ATOMIC_SEQ_CST)) {
        if (rcl_wait_set_clear(&set) != RCL_RET_OK ||
            rcl_wait_set_add_subscription(&set, &r->velocity, NULL) != RCL_RET_OK ||
            rcl_wait_set_add_guard_condition(&set, &r->over, NULL) != RCL_RET_OK) {
            fprintf(stderr, "error: %s\n", rcl_get_error_string().str);
            return FAULT;
        }
        if (rcl_wait(&set, CHECK_NS) != RCL_RET_OK)
            rcl_reset_error();
        take_velocity(r);
        if (now_ns() - checked_ns > CHECK_NS) {
            checked_ns = now_ns();
            look_at_type(r);
        }
    }
    if (rcl_wait_set_fini(&set) != RCL_RET_OK)
        rcl_reset_error();
    return DONE;
}

/* ---- The process */

/* Leaves the ROS 2 system, so that other nodes do not wait for this one. */
static void leave(struct robot *r)
{
    bool ok = rcl_subscription_fini(&r->velocity, &r->node) == RCL_RET_OK;
    ok = transforms_end(&r->transforms, &r->node) && ok;
    ok = states_end(&r->states, &r->node) && ok;
    ok = images_end(&r->images, &r->node) && ok;
    for (size_t i = 0; i < r->sensor_count; i++)
        ok = rcl_publisher_fini(&r->sensors[i].publisher, &r->node) == RCL_RET_OK && ok;
    ok = rcl_publisher_fini(&r->odometry, &r->node) == RCL_RET_OK && ok;
    ok = rcl_publisher_fini(&r->clock, &r->node) == RCL_RET_OK && ok;
    ok = rcl_guard_condition_fini(&r->over) == RCL_RET_OK && ok;
    ok = rcl_node_fini(&r->node) == RCL_RET_OK && ok;
    ok = rcl_shutdown(&r->context) == RCL_RET_OK && ok;
    ok = rcl_context_fini(&r->context) == RCL_RET_OK && ok;
    if (!ok)
        rcl_reset_error();
}

/* Reads the argument that describes a sensor. */
static void read_sensor(struct robot *r, const char *text)
{
    struct sensor *sensor = &r->sensors[r->sensor_count];
    struct seat *seat = &r->seats[r->sensor_count];
    char kind[8];
    if (r->sensor_count == ROS_SENSORS_MOST ||
        sscanf(text, "%7[^=]=%255[^,],%lf,%lf", kind, sensor->topic, &seat->x_m, &seat->y_m) != 4)
        return;
    sensor->kind = strcmp(kind, "scan") == 0 ? ROS_SCAN : ROS_IMU;
    /* The lidar on the topic `scan` is the one that programs call `lidar`. */
    snprintf(seat->frame, sizeof seat->frame, "%s_link",
             strcmp(sensor->topic, "scan") == 0 ? "lidar" : sensor->topic);
    r->sensor_count++;
}

/* Reads the arguments before `--`. Returns the index of `--`. */
static int read_arguments(struct robot *r, int argc, char **argv)
{
    int i = 2;
    r->socket = argc > 1 ? (int)strtol(argv[1], NULL, 10) : -1;
    for (; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strcmp(argv[i], "stamped") == 0)
            r->stamped = true;
        else if (!images_argument(&r->images, argv[i]))
            read_sensor(r, argv[i]);
    }
    return i;
}

int main(int argc, char **argv)
{
    static struct robot r;
    pthread_t publisher;
    int status;
    const int first = read_arguments(&r, argc, argv);
    /* The simulator ends this process by closing the socket. */
    signal(SIGINT, SIG_IGN);
    signal(SIGTERM, SIG_IGN);
    signal(SIGPIPE, SIG_IGN);
    if (!join(&r, argc - first, argv + first) || !open_topics(&r) || !start_transforms(&r) ||
        !report(&r))
        return FAULT;
    if (pthread_create(&publisher, NULL, publish_all, &r) != 0) {
        fprintf(stderr, "error: cannot start a thread\n");
        return FAULT;
    }
    status = listen_until_over(&r);
    if (status == DONE && pthread_join(publisher, NULL) == 0)
        leave(&r);
    return status;
}
