#include "inputs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>

#include <rcl/error_handling.h>
#include <rmw/qos_profiles.h>

#include "operated.h"
#include "sensors.h"

static void add(struct inputs *inputs, enum ros_kind kind, const char *name)
{
    struct input *input = &inputs->each[inputs->count++];
    input->kind = kind;
    snprintf(input->name, sizeof input->name, "%s", name);
}

bool inputs_is_sensor(const struct input *input)
{
    return input->kind == ROS_SCAN || input->kind == ROS_IMU || input->kind == ROS_BUMPER;
}

static enum ros_kind kind_of(const struct frob_control *control)
{
    switch (control->kind) {
    case FROB_IMU: return ROS_IMU;
    case FROB_HOLD: return ROS_BUMPER;
    default: return ROS_SCAN;
    }
}

bool inputs_is_needed(const struct input *input)
{
    switch (input->kind) {
    /* Robots without a battery topic are common, and most programs do not use it. */
    case ROS_BATTERY: return false;
    /* An operator may start rviz later, or never press a button. */
    case ROS_CLICK:
    case ROS_PRESS: return false;
    /* If a transform is missing, a warning names its frames. */
    case ROS_TF:
    case ROS_TF_STATIC: return false;
    case ROS_TOPIC: return input->own.parts.event == NULL;
    default: return true;
    }
}

bool inputs_is_reliable(const struct input *input)
{
    return input->kind == ROS_CLICK || input->kind == ROS_PRESS || input->kind == ROS_TF_STATIC;
}

/* Adds one of the program's own topics. */
static bool add_own(struct inputs *inputs, const struct frob_program *program, size_t number,
                    char *why, size_t room)
{
    const struct frob_topic *topic = &program->node->inputs[number];
    struct own_topic *own = &inputs->each[inputs->count].own;
    add(inputs, ROS_TOPIC, topic->name);
    own->number = (uint32_t)number;
    own->parts = topic_parts_of(program->input, topic);
    own->span = topic_span_of(own->parts.whole);
    if (!message_type_find(&own->type, topic->type, why, room) ||
        !mapping_of(&own->mapping, &own->type, own->parts.message, program->node, why, room))
        return false;
    own->message = message_create(&own->type);
    if (own->message == NULL)
        snprintf(why, room, "not enough memory");
    else if (own->span.end - own->span.first > ROS_VALUE_MOST)
        snprintf(why, room, "a value of `%s` has %zu bytes, more than the maximum of %d",
                 topic->field, own->span.end - own->span.first, ROS_VALUE_MOST);
    else
        return true;
    return false;
}

/* Returns whether any of the program's inputs has messages whose data refers to a frame. */
static bool has_frames(const struct inputs *inputs)
{
    for (size_t i = 0; i < inputs->count; i++)
        if (inputs->each[i].kind == ROS_SCAN || inputs->each[i].kind == ROS_IMU ||
            inputs->each[i].kind == ROS_CLICK)
            return true;
    return false;
}

/* Maximum number of topics besides those of sensors and controls and the program's own. */
enum { OTHERS_MOST = 6 };

/* Adds the topics of the console's buttons and map. Returns false if two buttons have the same
 * topic. */
static bool add_operated(struct inputs *inputs, const struct frob_program *program, char *why,
                         size_t room)
{
    for (size_t i = 0; i < program->control_count && i < ROS_CONTROLS_MOST; i++) {
        const struct frob_control *control = &program->console[i];
        char name[ROS_NAME] = "clicked_point";
        if (control->kind != FROB_MAP && control->kind != FROB_BUTTON)
            continue;
        if (control->kind == FROB_BUTTON)
            operated_topic(control, name, sizeof name);
        for (size_t k = 0; k < inputs->count; k++)
            if (inputs->each[k].kind == ROS_PRESS && strcmp(inputs->each[k].name, name) == 0) {
                snprintf(
                    why, room,
                    "the buttons `%s` and `%s` of the program have the same topic, %s: rename one "
                    "of them",
                    program->console[inputs->each[k].control].label, control->label, name);
                return false;
            }
        inputs->each[inputs->count].control = (uint32_t)i;
        add(inputs, control->kind == FROB_MAP ? ROS_CLICK : ROS_PRESS, name);
    }
    return true;
}

bool inputs_of(struct inputs *inputs, const struct frob_program *program, bool use_sim_time,
               bool has_joystick, char *why, size_t room)
{
    const size_t own = program->node != NULL ? program->node->input_count : 0;
    size_t sensors = 0;
    tf_start(&inputs->tf);
    inputs->each = (struct input *)calloc(own + ROS_SENSORS_MOST + ROS_CONTROLS_MOST + OTHERS_MOST,
                                          sizeof *inputs->each);
    inputs->values = (char *)calloc(1, program->input_size + 1);
    inputs->value = (struct ros_topic_message *)calloc(1, ROS_MESSAGE_MOST);
    if (inputs->each == NULL || inputs->values == NULL || inputs->value == NULL) {
        snprintf(why, room, "not enough memory");
        return false;
    }
    for (size_t i = 0; i < own; i++)
        if (!add_own(inputs, program, i, why, room))
            return false;
    if (program->node == NULL) {
        add(inputs, ROS_ODOMETRY, "odom");
        add(inputs, ROS_BATTERY, "battery_state");
    }
    if (use_sim_time)
        add(inputs, ROS_CLOCK, "/clock");
    for (size_t i = 0; i < program->control_count; i++) {
        char name[ROS_NAME];
        if (!ros_topic_of(&program->console[i], name, sizeof name) ||
            ros_first_user(program, i) < i)
            continue;
        if (sensors++ == ROS_SENSORS_MOST) {
            snprintf(why, room, "the program uses more than eight sensors and bumpers");
            return false;
        }
        inputs->each[inputs->count].control = (uint32_t)i;
        add(inputs, kind_of(&program->console[i]), name);
    }
    if (!add_operated(inputs, program, why, room))
        return false;
    if (has_joystick)
        add(inputs, ROS_JOY, "joy");
    inputs->tf.is_read = has_frames(inputs) && tf_type() != NULL;
    if (inputs->tf.is_read) {
        add(inputs, ROS_TF, "/tf");
        add(inputs, ROS_TF_STATIC, "/tf_static");
    }
    return true;
}

static const rosidl_message_type_support_t *type_of(struct input *input)
{
    switch (input->kind) {
    case ROS_TOPIC: input->topic.type = input->own.type.name; return input->own.type.support;
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
    case ROS_BUMPER:
        input->topic.type = "std_msgs/msg/Bool";
        return std_msgs__msg__Bool__init(&input->message.bumper)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(std_msgs, msg, Bool)
                   : NULL;
    case ROS_BATTERY:
        input->topic.type = "sensor_msgs/msg/BatteryState";
        return sensor_msgs__msg__BatteryState__init(&input->message.battery)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, BatteryState)
                   : NULL;
    case ROS_JOY:
        input->topic.type = "sensor_msgs/msg/Joy";
        return sensor_msgs__msg__Joy__init(&input->message.joy)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, Joy)
                   : NULL;
    case ROS_PRESS:
        input->topic.type = "std_msgs/msg/Empty";
        return std_msgs__msg__Empty__init(&input->message.press)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(std_msgs, msg, Empty)
                   : NULL;
    case ROS_CLICK:
        input->topic.type = "geometry_msgs/msg/PointStamped";
        return geometry_msgs__msg__PointStamped__init(&input->message.click)
                   ? ROSIDL_GET_MSG_TYPE_SUPPORT(geometry_msgs, msg, PointStamped)
                   : NULL;
    case ROS_TF:
    case ROS_TF_STATIC:
        input->topic.type = "tf2_msgs/msg/TFMessage";
        return geometry_msgs__msg__TransformStamped__Sequence__init(
                   &input->message.transforms.transforms, 0)
                   ? tf_type()
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

/* Queue size, the same as in the package tf2_ros. */
enum { TRANSFORMS_KEPT = 100 };

/* Best-effort delivery is compatible with every publisher. */
static rmw_qos_profile_t qos_of(const struct input *input)
{
    rmw_qos_profile_t qos = rmw_qos_profile_sensor_data;
    if (input->kind == ROS_TF || input->kind == ROS_TF_STATIC)
        qos.depth = TRANSFORMS_KEPT;
    if (input->kind == ROS_TF_STATIC)
        qos.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
    if (inputs_is_reliable(input))
        qos.reliability = RMW_QOS_POLICY_RELIABILITY_RELIABLE;
    return qos;
}

const char *inputs_subscribe(struct inputs *inputs, const rcl_node_t *node)
{
    rcl_subscription_options_t options = rcl_subscription_get_default_options();
    for (size_t i = 0; i < inputs->count; i++) {
        struct input *input = &inputs->each[i];
        options.qos = qos_of(input);
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
    /* Drops the message if the socket is full. */
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
    struct frames_pose pose;
    if (m->ranges.size > ROS_RAYS_MOST) {
        fprintf(stderr, "warning: a message on %s is ignored: it has more than %d ranges\n",
                input->topic.name, ROS_RAYS_MOST);
        return;
    }
    scan->head = head(ROS_SCAN, offsetof(struct ros_scan, ranges_m) +
                                    m->ranges.size * sizeof *scan->ranges_m);
    scan->origin = origin(input, &m->header);
    scan->placing =
        tf_place(&inputs->tf, false, m->header.frame_id.data, scan->origin.arrived_ns, &pose);
    if (scan->placing.fate == ROS_FOUND)
        scan->is_tilted = !frames_seat(&pose, &scan->seat);
    scan->first_rad = (double)m->angle_min;
    scan->step_rad = (double)m->angle_increment;
    scan->nearest_m = (double)m->range_min;
    scan->farthest_m = (double)m->range_max;
    scan->count = (uint32_t)m->ranges.size;
    if (m->ranges.size > 0)
        memcpy(scan->ranges_m, m->ranges.data, m->ranges.size * sizeof *scan->ranges_m);
    send_message(socket, &scan->head);
}

static void send_imu(const struct inputs *inputs, const struct input *input, int socket)
{
    const sensor_msgs__msg__Imu *m = &input->message.imu;
    struct frames_pose pose;
    struct ros_imu imu;
    memset(&imu, 0, sizeof imu);
    imu.head = head(ROS_IMU, sizeof imu);
    imu.origin = origin(input, &m->header);
    imu.placing =
        tf_place(&inputs->tf, false, m->header.frame_id.data, imu.origin.arrived_ns, &pose);
    if (imu.placing.fate == ROS_FOUND)
        memcpy(imu.mounting, pose.rotation, sizeof imu.mounting);
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
    /* According to the message's definition, -1 means that there is no orientation. */
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

/* Returns whether to report a fault in a message. Each unknown string is reported only once, and
 * none once `told_texts` is full. */
static bool is_new(struct own_topic *own, const struct mapping_fault *fault)
{
    const size_t most = sizeof own->told_texts / sizeof own->told_texts[0];
    uint32_t digest = 2166136261u; /* FNV-1a */
    if (fault->text == NULL) {
        const bool told = own->told;
        own->told = true;
        return !told;
    }
    for (const char *c = fault->text; *c != '\0'; c++)
        digest = (digest ^ (unsigned char)*c) * 16777619u;
    for (size_t k = 0; k < own->told_text_count; k++)
        if (own->told_texts[k] == digest)
            return false;
    if (own->told_text_count == most)
        return false;
    own->told_texts[own->told_text_count++] = digest;
    return true;
}

/* Writes the strings of an enumeration as a list. */
static void list_texts(const struct mapping *m, char *list, size_t room)
{
    size_t length = 0;
    list[0] = '\0';
    for (size_t k = 0; k < m->value->count && length < room; k++) {
        const char *separator = k == 0 ? "" : k + 1 == m->value->count ? " and " : ", ";
        length += (size_t)snprintf(list + length, room - length, "%s\"%s\"", separator,
                                   m->texts->texts[k]);
    }
}

/* Reports a message with a fault. `is_usable`: the message is accepted, with `Nothing` for an
 * unknown string. */
static void tell(const struct input *input, const struct mapping_fault *fault, bool is_usable)
{
    const char *type;
    char list[500], text[80];
    if (fault->text == NULL) {
        fprintf(stderr,
                "warning: a message on %s is ignored: its `%s` does not have the %zu elements "
                "that the program requires\n",
                input->topic.name, fault->of->member->name_, fault->of->part_count);
        return;
    }
    type = fault->of->texts->type;
    list_texts(fault->of, list, sizeof list);
    snprintf(text, sizeof text, "%s", fault->text);
    for (char *c = text; *c != '\0'; c++)
        if ((unsigned char)*c < ' ' || *c == '\x7f')
            *c = '?';
    fprintf(stderr,
            "warning: a message on %s %s: its `%s` is \"%s\", but `%s` only has the text%s %s",
            input->topic.name, is_usable ? "is read with `Nothing`" : "is ignored",
            fault->of->member->name_, text, type, fault->of->value->count == 1 ? "" : "s", list);
    if (!is_usable)
        fprintf(stderr, "; add a constructor, or declare the field as a `Maybe %s`", type);
    fprintf(stderr, "\n");
}

/* Sends a message on one of the program's own topics. */
static void send_value(struct inputs *inputs, struct input *input, int socket)
{
    struct own_topic *own = &input->own;
    struct ros_topic_message *value = inputs->value;
    struct mapping_fault fault;
    bool is_usable;
    const size_t size = own->span.end - own->span.first;
    const std_msgs__msg__Header *its_header =
        (const std_msgs__msg__Header *)message_header(&own->type, own->message);
    own->count++;
    memset(inputs->values + own->span.first, 0, size);
    if (own->parts.event != NULL)
        inputs->values[own->parts.event->offset] = 1;
    is_usable = mapping_read(&own->mapping, own->message, inputs->values, &fault);
    if (fault.of != NULL && is_new(own, &fault))
        tell(input, &fault, is_usable);
    if (!is_usable)
        return;
    value->head = head(ROS_TOPIC, sizeof *value + size);
    value->topic = own->number;
    value->number = own->count;
    value->stamp_ns = its_header == NULL ? 0 : stamp_of(its_header);
    value->arrived_ns = node_now_ns();
    memcpy(value + 1, inputs->values + own->span.first, size);
    send_message(socket, &value->head);
}

static void send_bumper(const struct input *input, int socket)
{
    struct ros_bumper bumper;
    memset(&bumper, 0, sizeof bumper);
    bumper.head = head(ROS_BUMPER, sizeof bumper);
    bumper.origin.control = input->control;
    bumper.origin.arrived_ns = node_now_ns();
    bumper.is_pressed = input->message.bumper.data;
    send_message(socket, &bumper.head);
}

static void send_joy(const struct input *input, int socket)
{
    const sensor_msgs__msg__Joy *m = &input->message.joy;
    struct ros_joy joy;
    memset(&joy, 0, sizeof joy);
    joy.head = head(ROS_JOY, sizeof joy);
    joy.origin = origin(input, &m->header);
    for (size_t i = 0; i < m->axes.size && i < ROS_JOY_MOST; i++)
        joy.axes[joy.axis_count++] = m->axes.data[i];
    for (size_t i = 0; i < m->buttons.size && i < ROS_JOY_MOST; i++)
        joy.is_down[joy.button_count++] = m->buttons.data[i] != 0;
    send_message(socket, &joy.head);
}

static void send_press(const struct input *input, int socket)
{
    const struct ros_press press = { head(ROS_PRESS, sizeof press), input->control };
    send_message(socket, &press.head);
}

static void send_click(const struct inputs *inputs, const struct input *input, int socket)
{
    const geometry_msgs__msg__PointStamped *m = &input->message.click;
    const double point[3] = { m->point.x, m->point.y, m->point.z };
    struct frames_pose pose;
    struct ros_click click;
    double found[3];
    memset(&click, 0, sizeof click);
    click.head = head(ROS_CLICK, sizeof click);
    click.origin = origin(input, &m->header);
    click.placing =
        tf_place(&inputs->tf, true, m->header.frame_id.data, click.origin.arrived_ns, &pose);
    if (click.placing.fate == ROS_FOUND) {
        frames_point(&pose, point, found);
        click.x_m = found[0];
        click.y_m = found[1];
    }
    send_message(socket, &click.head);
}

static void take_transforms(struct inputs *inputs, const struct input *input)
{
    tf_take(&inputs->tf, &input->message.transforms, input->topic.name,
            input->kind == ROS_TF_STATIC, node_now_ns());
}

static void send_battery(const struct input *input, int socket)
{
    struct ros_battery battery;
    memset(&battery, 0, sizeof battery);
    battery.head = head(ROS_BATTERY, sizeof battery);
    battery.voltage_v = (double)input->message.battery.voltage;
    send_message(socket, &battery.head);
}

void inputs_take(struct inputs *inputs, struct input *input, int socket)
{
    void *message = input->kind == ROS_TOPIC ? input->own.message : &input->message;
    while (rcl_take(&input->subscription, message, NULL, NULL) == RCL_RET_OK) {
        input->heard = true;
        switch (input->kind) {
        case ROS_TOPIC: send_value(inputs, input, socket); break;
        case ROS_SCAN: send_scan(inputs, input, socket); break;
        case ROS_IMU: send_imu(inputs, input, socket); break;
        case ROS_BUMPER: send_bumper(input, socket); break;
        case ROS_BATTERY: send_battery(input, socket); break;
        case ROS_JOY: send_joy(input, socket); break;
        case ROS_PRESS: send_press(input, socket); break;
        case ROS_CLICK: send_click(inputs, input, socket); break;
        case ROS_TF:
        case ROS_TF_STATIC: take_transforms(inputs, input); break;
        case ROS_CLOCK: send_clock(inputs, input, socket); break;
        default:
            tf_name(&inputs->tf, &input->message.odometry);
            send_odometry(&input->message.odometry, socket);
            break;
        }
    }
    rcl_reset_error(); /* there are no more messages */
}
