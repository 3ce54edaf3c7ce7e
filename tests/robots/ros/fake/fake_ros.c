#include "fake_ros.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* The robot publishes its odometry at this rate. */
#define PERIOD_NS INT64_C(20000000)

/* The faults that tests request with the environment variable FAKE_ROS, as in "silent=1 nan=0.5":
 * each begins this number of seconds after the start. */
static double fault_after(const char *name)
{
    const char *text = getenv("FAKE_ROS");
    const size_t length = strlen(name);
    while (text != NULL && *text != '\0') {
        if (strncmp(text, name, length) == 0 && text[length] == '=')
            return strtod(text + length + 1, NULL);
        text = strchr(text, ' ');
        text = text != NULL ? text + 1 : NULL;
    }
    return INFINITY;
}

static int64_t now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

static double passed_s(void)
{
    static int64_t start_ns = 0;
    if (start_ns == 0)
        start_ns = now_ns();
    return (double)(now_ns() - start_ns) * 1e-9;
}

static bool has(const char *fault)
{
    return passed_s() >= fault_after(fault);
}

/* ---- The robot */

static struct {
    double x, heading, v, turn;
    int64_t next_ns;
    bool stamped;
    bool simulated; /* there is a simulator's clock */
} robot;

/* Writes a line into the file that FAKE_ROS_LOG names. */
static void write_log(const char *line)
{
    const char *name = getenv("FAKE_ROS_LOG");
    FILE *log = name != NULL ? fopen(name, "a") : NULL;
    if (log == NULL)
        return;
    fprintf(log, "%s\n", line);
    fclose(log);
}

/* Writes each velocity that differs from the previous one into the file that FAKE_ROS_LOG names. */
static void drive(double v, double turn)
{
    static bool wrote = false;
    char line[80];
    const bool changes = !wrote || v != robot.v || turn != robot.turn;
    robot.v = v;
    robot.turn = turn;
    wrote = true;
    snprintf(line, sizeof line, "%.3f %.3f%s", v, turn, robot.stamped ? " stamped" : "");
    if (changes)
        write_log(line);
}

/* Writes the verdicts into the log, without times. */
static void write_diagnostics(const diagnostic_msgs__msg__DiagnosticArray *m)
{
    for (size_t i = 0; i < m->status.size; i++) {
        char line[300];
        snprintf(line, sizeof line, "diagnostics: %d, %s: %.8s", m->status.data[i].level,
                 m->status.data[i].name.data, m->status.data[i].message.data);
        write_log(line);
    }
}

/* Writes the markers of the first message into the log, and those that are removed. */
static void write_markers(const visualization_msgs__msg__MarkerArray *m)
{
    static bool wrote = false;
    for (size_t i = 0; i < m->markers.size; i++) {
        const visualization_msgs__msg__Marker *marker = &m->markers.data[i];
        const geometry_msgs__msg__Point *points = marker->points.data;
        const bool is_text = marker->type == visualization_msgs__msg__Marker__TEXT_VIEW_FACING;
        char line[300];
        if (marker->action == visualization_msgs__msg__Marker__DELETE)
            snprintf(line, sizeof line, "marker %d: removed", (int)marker->id);
        else if (is_text)
            snprintf(line, sizeof line, "marker %d: in %s, `%s` at %g %g", (int)marker->id,
                     marker->header.frame_id.data, marker->text.data, marker->pose.position.x,
                     marker->pose.position.y);
        else
            snprintf(line, sizeof line, "marker %d: in %s, type %d, %zu points, %g %g to %g %g",
                     (int)marker->id, marker->header.frame_id.data, (int)marker->type,
                     marker->points.size, points[0].x, points[0].y, points[1].x, points[1].y);
        if (!wrote || marker->action == visualization_msgs__msg__Marker__DELETE)
            write_log(line);
    }
    wrote = true;
}

/* Appends a text on ~/TOPIC to the file FAKE_ROS_BAG.TOPIC, with a zero byte at its end. */
static void write_bag(const char *topic, const char *text)
{
    const char *bag = getenv("FAKE_ROS_BAG");
    char name[500];
    FILE *file;
    snprintf(name, sizeof name, "%s.%s", bag != NULL ? bag : "", topic + 2);
    file = bag != NULL ? fopen(name, "a") : NULL;
    if (file == NULL)
        return;
    fwrite(text, 1, strlen(text) + 1, file);
    fclose(file);
}

/* Writes transforms to fixed frames into the log, and the first one to a frame that moves. */
static void write_transforms(const char *topic,
                             const geometry_msgs__msg__TransformStamped__Sequence *transforms)
{
    static bool wrote = false;
    if (wrote && strcmp(topic, "/tf") == 0)
        return;
    for (size_t i = 0; i < transforms->size; i++) {
        const geometry_msgs__msg__TransformStamped *t = &transforms->data[i];
        char line[300];
        snprintf(line, sizeof line, "%s: %s to %s, %g %g", topic, t->header.frame_id.data,
                 t->child_frame_id.data, t->transform.translation.x, t->transform.translation.y);
        write_log(line);
    }
    wrote = wrote || strcmp(topic, "/tf") == 0;
}

rcl_ret_t rcl_publish(const rcl_publisher_t *publisher, const void *message, void *allocation)
{
    const geometry_msgs__msg__TwistStamped *stamped =
        (const geometry_msgs__msg__TwistStamped *)message;
    const geometry_msgs__msg__Twist *twist =
        robot.stamped ? &stamped->twist : (const geometry_msgs__msg__Twist *)message;
    (void)allocation;
    if (has("crash"))
        abort();
    if (strcmp(publisher->topic, "/diagnostics") == 0) {
        write_diagnostics((const diagnostic_msgs__msg__DiagnosticArray *)message);
        return RCL_RET_OK;
    }
    if (strncmp(publisher->topic, "/tf", 3) == 0) {
        write_transforms(publisher->topic, message);
        return RCL_RET_OK;
    }
    if (strcmp(publisher->topic, "~/markers") == 0) {
        write_markers((const visualization_msgs__msg__MarkerArray *)message);
        return RCL_RET_OK;
    }
    if (publisher->topic[0] == '~') {
        write_bag(publisher->topic, ((const std_msgs__msg__String *)message)->data.data);
        return RCL_RET_OK;
    }
    if (strcmp(publisher->topic, "/blocked") == 0)
        write_log(((const std_msgs__msg__Bool *)message)->data ? "blocked" : "not blocked");
    if (strcmp(publisher->topic, "/state") == 0)
        write_log(((const std_msgs__msg__String *)message)->data.data);
    if (strcmp(publisher->topic, "/cmd_vel") != 0 && strcmp(publisher->topic, "/base/cmd_vel") != 0)
        return RCL_RET_OK;
    drive(twist->linear.x, twist->angular.z);
    return RCL_RET_OK;
}

/* The simulator's clock runs at half the speed of ours. */
static int64_t simulated_ns(void)
{
    const double time_s = 1000.0 + passed_s() / 2 - (has("clock_back") ? 500.0 : 0.0);
    return (int64_t)(time_s * 1e9);
}

static void clock_message(rosgraph_msgs__msg__Clock *m)
{
    m->clock.sec = (int32_t)(simulated_ns() / 1000000000);
    m->clock.nanosec = (uint32_t)(simulated_ns() % 1000000000);
}

/* Fills in an odometry. Returns false if the robot is silent. */
static bool odometry(nav_msgs__msg__Odometry *m, int64_t stamp_ns)
{
    const double dt = (double)PERIOD_NS * 1e-9;
    robot.heading += robot.turn * dt;
    robot.x += robot.v * dt;
    if (has("silent"))
        return false;
    if (has("crash"))
        abort();
    memset(m, 0, sizeof *m);
    if (robot.simulated)
        stamp_ns = simulated_ns();
    if (has("back"))
        stamp_ns -= 30 * INT64_C(1000000000);
    if (has("old"))
        stamp_ns -= 400 * INT64_C(1000000);
    m->header.stamp.sec = (int32_t)(stamp_ns / 1000000000);
    m->header.stamp.nanosec = (uint32_t)(stamp_ns % 1000000000);
    m->pose.pose.position.x = has("nan") ? NAN : robot.x;
    m->pose.pose.orientation.z = sin(robot.heading / 2);
    m->pose.pose.orientation.w = cos(robot.heading / 2);
    m->twist.twist.linear.x = robot.v;
    m->twist.twist.angular.z = robot.turn;
    return true;
}

/* A lidar with 360 rays that looks ahead in the middle of its scan, 1 m before a wall. Ray 0 points
 * back. The rays on its left are lost. */
static void scan(sensor_msgs__msg__LaserScan *m)
{
    static float ranges[360];
    const double pi = acos(-1.0);
    for (size_t i = 0; i < 360; i++) {
        const double bearing = ((double)i - 180.0) * pi / 180.0;
        ranges[i] = cos(bearing) > 0.1 ? (float)((1.0 - robot.x) / cos(bearing)) : INFINITY;
        if (bearing > 1.0 && bearing < 2.0)
            ranges[i] = NAN;
    }
    memset(m, 0, sizeof *m);
    m->header.frame_id.data = has("frame") ? "/laser" : NULL;
    m->angle_min = (float)-pi;
    m->angle_increment = has("no_angle") ? 0.0f : (float)(pi / 180.0);
    m->range_min = 0.1f;
    m->range_max = 8.0f;
    m->ranges.data = ranges;
    m->ranges.size = 360;
}

/* With the fault "imu_frame", the unit is in the lidar's frame, and measures an acceleration. */
static void imu(sensor_msgs__msg__Imu *m)
{
    memset(m, 0, sizeof *m);
    m->header.frame_id.data = has("imu_frame") ? "laser" : NULL;
    m->linear_acceleration.x = has("imu_frame") ? 0.5 : 0.0;
    m->angular_velocity.z = robot.turn + 0.25;
    m->linear_acceleration.z = 9.81;
    m->orientation.z = sin(0.25);
    m->orientation.w = cos(0.25);
}

/* The lidar's frame: with the fault "frame" it is `laser`, whose transforms a node publishes after the
 * fault "frames", together with that from `map` to `odom`. It looks back, and it is upside down
 * with the fault "upside_down", tilted with the fault "tilt". */
static bool transforms(geometry_msgs__msg__TransformStamped__Sequence *sequence, bool is_fixed)
{
    static geometry_msgs__msg__TransformStamped t;
    memset(&t, 0, sizeof t);
    t.header.frame_id.data = is_fixed ? "base_link" : "map";
    t.child_frame_id.data = is_fixed ? "laser" : "odom";
    t.transform.translation.x = is_fixed ? 0.125 : 10.0;
    if (is_fixed && has("upside_down"))
        t.transform.rotation.y = 1.0;
    else if (is_fixed && has("tilt"))
        t.transform.rotation.x = t.transform.rotation.w = sqrt(0.5);
    else if (is_fixed)
        t.transform.rotation.z = 1.0;
    else
        t.transform.rotation.w = 1.0;
    if (has("bad_frames"))
        t.transform.rotation.z = NAN;
    sequence->data = &t;
    sequence->size = 1;
    return has("frames");
}

/* The operator clicks on the map once, after the fault "click". */
static bool click(geometry_msgs__msg__PointStamped *m)
{
    static bool done = false;
    const bool clicks = has("click") && !done;
    memset(m, 0, sizeof *m);
    m->header.frame_id.data = has("map") ? "map" : "odom";
    m->point.x = has("map") ? 12 : 2;
    m->point.y = has("nan_click") ? NAN : 1;
    done = done || has("click");
    return clicks;
}

/* The operator presses the button of a topic once, after the fault "press". */
static bool press(void)
{
    static bool done = false;
    const bool presses = has("press") && !done;
    done = done || has("press");
    return presses;
}

/* A joystick. Its first axis moves to 0.5 and its button 1 goes down after the fault "joy", until the
 * fault "joy_up". It is silent after the fault "joy_silent". */
static bool joy(sensor_msgs__msg__Joy *m)
{
    static float axes[2];
    static int32_t buttons[2];
    const bool down = has("joy") && !has("joy_up");
    axes[0] = has("joy_nan") ? NAN : down ? 0.5f : 0.0f;
    buttons[1] = down;
    memset(m, 0, sizeof *m);
    m->axes.data = axes;
    m->buttons.data = buttons;
    m->axes.size = m->buttons.size = has("joy_small") ? 1 : 2;
    return !has("joy_silent");
}

/* A camera that sees only red. Its rows have three bytes more than they need. */
static void image(sensor_msgs__msg__Image *m)
{
    enum { WIDTH = 40, HEIGHT = 30, STEP = 3 * WIDTH + 3 };
    static uint8_t pixels[STEP * HEIGHT];
    for (size_t y = 0; y < HEIGHT; y++)
        for (size_t x = 0; x < WIDTH; x++)
            pixels[y * STEP + 3 * x + 2] = 250;
    memset(m, 0, sizeof *m);
    m->encoding.data = has("yuv") ? "yuv422" : "bgr8";
    m->width = WIDTH;
    m->height = HEIGHT;
    m->step = STEP;
    m->data.data = pixels;
    m->data.size = sizeof pixels;
}

/* The commands that the node of a simulated robot receives: during the fault "drive", drive ahead. */
static bool velocity(geometry_msgs__msg__Twist *m)
{
    memset(m, 0, sizeof *m);
    m->linear.x = has("nan") ? NAN : 0.3;
    return has("drive") && !has("silent");
}

/* Another node enables the program during the fault "enable", until the fault "disable". */
static bool enable(std_msgs__msg__Bool *m)
{
    m->data = !has("disable");
    return has("enable");
}

/* Another node publishes the words in FAKE_ROS_WORDS, one after the other; the last one repeatedly. */
static bool word(std_msgs__msg__String *m)
{
    static const char *next = NULL;
    char text[40];
    size_t length;
    if (next == NULL)
        next = getenv("FAKE_ROS_WORDS");
    if (next == NULL)
        return false;
    length = strcspn(next, " ");
    snprintf(text, sizeof text, "%.*s", (int)length, next);
    next += next[length] == ' ' ? length + 1 : 0;
    return rosidl_runtime_c__String__assign(&m->data, text);
}

/* The sensors send a message after every fifth odometry message. */
static int64_t *next_of(const rcl_subscription_t *subscription)
{
    static int64_t scan_ns = 0, imu_ns = 0, clock_ns = 0, velocity_ns = 0, bumper_ns = 0,
                   battery_ns = 0, image_ns = 0, fixed_ns = 0, moving_ns = 0, click_ns = 0,
                   word_ns = 0, press_ns = 0, joy_ns = 0;
    if (strcmp(subscription->topic, "/tf") == 0)
        return &moving_ns;
    if (strcmp(subscription->topic, "/tf_static") == 0)
        return &fixed_ns;
    if (subscription->type == &fake_geometry_msgs_PointStamped)
        return &click_ns;
    if (subscription->type == &fake_std_msgs_Empty)
        return &press_ns;
    if (subscription->type == &fake_sensor_msgs_Joy)
        return &joy_ns;
    if (subscription->type == &fake_sensor_msgs_Image ||
        subscription->type == &fake_sensor_msgs_CompressedImage)
        return &image_ns;
    if (subscription->type == &fake_std_msgs_String)
        return &word_ns;
    if (subscription->type == &fake_std_msgs_Bool)
        return &bumper_ns;
    if (subscription->type == &fake_sensor_msgs_BatteryState)
        return &battery_ns;
    if (subscription->type == &fake_geometry_msgs_Twist)
        return &velocity_ns;
    if (subscription->type == &fake_rosgraph_msgs_Clock)
        return &clock_ns;
    if (subscription->type == &fake_sensor_msgs_LaserScan)
        return &scan_ns;
    return subscription->type == &fake_sensor_msgs_Imu ? &imu_ns : &robot.next_ns;
}

rcl_ret_t rcl_take(const rcl_subscription_t *subscription, void *into, void *information,
                   void *allocation)
{
    int64_t *next_ns = next_of(subscription);
    const int64_t stamp_ns = *next_ns;
    (void)information;
    (void)allocation;
    if (now_ns() < *next_ns)
        return RCL_RET_ERROR;
    if (next_ns == &robot.next_ns) {
        *next_ns += PERIOD_NS;
        return odometry((nav_msgs__msg__Odometry *)into, stamp_ns) ? RCL_RET_OK : RCL_RET_ERROR;
    }
    *next_ns = now_ns() + 5 * PERIOD_NS;
    if (subscription->type == &fake_std_msgs_Bool && strstr(subscription->topic, "bump") == NULL)
        return enable((std_msgs__msg__Bool *)into) ? RCL_RET_OK : RCL_RET_ERROR;
    if (subscription->type == &fake_geometry_msgs_Twist)
        return velocity((geometry_msgs__msg__Twist *)into) ? RCL_RET_OK : RCL_RET_ERROR;
    if (strncmp(subscription->topic, "/tf", 3) == 0)
        return transforms(into, strcmp(subscription->topic, "/tf_static") == 0) ? RCL_RET_OK
                                                                                : RCL_RET_ERROR;
    if (subscription->type == &fake_std_msgs_Empty)
        return press() ? RCL_RET_OK : RCL_RET_ERROR;
    if (subscription->type == &fake_sensor_msgs_Joy)
        return joy((sensor_msgs__msg__Joy *)into) ? RCL_RET_OK : RCL_RET_ERROR;
    if (subscription->type == &fake_geometry_msgs_PointStamped)
        return click((geometry_msgs__msg__PointStamped *)into) ? RCL_RET_OK : RCL_RET_ERROR;
    if (subscription->type == &fake_sensor_msgs_CompressedImage)
        return RCL_RET_ERROR;
    if (subscription->type == &fake_std_msgs_String)
        return word((std_msgs__msg__String *)into) ? RCL_RET_OK : RCL_RET_ERROR;
    if (subscription->type == &fake_sensor_msgs_Image) {
        image((sensor_msgs__msg__Image *)into);
    } else if (subscription->type == &fake_std_msgs_Bool) {
        ((std_msgs__msg__Bool *)into)->data = has("bump");
    } else if (subscription->type == &fake_sensor_msgs_BatteryState) {
        ((sensor_msgs__msg__BatteryState *)into)->voltage = 12.5f;
    } else if (subscription->type == &fake_rosgraph_msgs_Clock) {
        *next_ns = now_ns() + PERIOD_NS / 2;
        clock_message((rosgraph_msgs__msg__Clock *)into);
    } else if (subscription->type == &fake_sensor_msgs_LaserScan)
        scan((sensor_msgs__msg__LaserScan *)into);
    else
        imu((sensor_msgs__msg__Imu *)into);
    return RCL_RET_OK;
}

rcl_ret_t rcl_wait(rcl_wait_set_t *set, int64_t timeout_ns)
{
    struct pollfd guard = { set->guard_conditions[0] != NULL ? set->guard_conditions[0]->ends[0]
                                                             : -1,
                            POLLIN, 0 };
    int64_t left_ns = timeout_ns;
    for (size_t i = 0; i < set->count; i++)
        if (*next_of(set->subscriptions[i]) - now_ns() < left_ns)
            left_ns = *next_of(set->subscriptions[i]) - now_ns();
    poll(&guard, 1, left_ns > 0 ? (int)((left_ns + 999999) / 1000000) : 0);
    for (size_t i = 0; i < set->count; i++)
        if (now_ns() < *next_of(set->subscriptions[i]))
            set->subscriptions[i] = NULL;
    return RCL_RET_OK;
}

/* ---- Other nodes */

static rcl_ret_t one(rcl_topic_endpoint_info_array_t *array, const char *type)
{
    array->size = 1;
    array->info_array = (rcl_topic_endpoint_info_t *)calloc(1, sizeof *array->info_array);
    array->info_array[0].node_name = "base";
    array->info_array[0].topic_type = type;
    return RCL_RET_OK;
}

rcl_ret_t rcl_get_publishers_info_by_topic(const rcl_node_t *node, rcutils_allocator_t *allocator,
                                           const char *topic, bool no_mangle,
                                           rcl_topic_endpoint_info_array_t *array)
{
    (void)node;
    (void)allocator;
    (void)no_mangle;
    if (has("alone"))
        return RCL_RET_OK;
    if (strstr(topic, "scan") != NULL)
        return one(array, "sensor_msgs/msg/LaserScan");
    if (strcmp(topic, "/cmd_vel") == 0)
        return one(array,
                   has("stamps") ? "geometry_msgs/msg/TwistStamped" : "geometry_msgs/msg/Twist");
    if (strcmp(topic, "/enable") == 0)
        return one(array, "std_msgs/msg/Bool");
    if (strcmp(topic, "/mode") == 0)
        return one(array, "std_msgs/msg/String");
    if (strcmp(topic, "/clock") == 0)
        return one(array, "rosgraph_msgs/msg/Clock");
    if (strstr(topic, "image") != NULL)
        return one(array, "sensor_msgs/msg/Image");
    if (strstr(topic, "/buttons/") != NULL)
        return one(array, "std_msgs/msg/Empty");
    if (strcmp(topic, "/joy") == 0)
        return one(array, "sensor_msgs/msg/Joy");
    if (strncmp(topic, "/tf", 3) == 0)
        return one(array, "tf2_msgs/msg/TFMessage");
    if (strstr(topic, "clicked_point") != NULL) {
        one(array, "geometry_msgs/msg/PointStamped");
        if (has("lossy"))
            array->info_array[0].qos_profile.reliability = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT;
        return RCL_RET_OK;
    }
    if (strstr(topic, "bump") != NULL)
        return one(array, "std_msgs/msg/Bool");
    if (strstr(topic, "battery") != NULL)
        return one(array, "sensor_msgs/msg/BatteryState");
    if (strstr(topic, "imu") != NULL)
        return one(array, "sensor_msgs/msg/Imu");
    return one(array,
               has("other_type") ? "geometry_msgs/msg/PoseStamped" : "nav_msgs/msg/Odometry");
}

rcl_ret_t rcl_get_subscriptions_info_by_topic(const rcl_node_t *node,
                                              rcutils_allocator_t *allocator, const char *topic,
                                              bool no_mangle,
                                              rcl_topic_endpoint_info_array_t *array)
{
    (void)node;
    (void)allocator;
    (void)topic;
    (void)no_mangle;
    if (strcmp(topic, "/blocked") == 0)
        return one(array, "std_msgs/msg/Bool");
    if (strcmp(topic, "/state") == 0)
        return one(array, "std_msgs/msg/String");
    one(array, has("wants_stamped") || robot.stamped ? "geometry_msgs/msg/TwistStamped"
                                                     : "geometry_msgs/msg/Twist");
    if (has("wants_old"))
        array->info_array[0].qos_profile.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
    return RCL_RET_OK;
}

rcl_ret_t rcl_topic_endpoint_info_array_fini(rcl_topic_endpoint_info_array_t *array,
                                             rcutils_allocator_t *allocator)
{
    (void)allocator;
    free(array->info_array);
    return RCL_RET_OK;
}

rcl_ret_t rcl_get_node_names(const rcl_node_t *node, rcl_allocator_t allocator,
                             rcutils_string_array_t *names, rcutils_string_array_t *spaces)
{
    static char space[] = "/", base[] = "base";
    (void)allocator;
    names->size = spaces->size = 2;
    names->data = (char **)calloc(2, sizeof *names->data);
    spaces->data = (char **)calloc(2, sizeof *spaces->data);
    names->data[0] = (char *)(uintptr_t)rcl_node_get_name(node);
    names->data[1] = has("same_name") ? names->data[0] : base;
    spaces->data[0] = spaces->data[1] = space;
    return RCL_RET_OK;
}

rcl_ret_t rcutils_string_array_fini(rcutils_string_array_t *array)
{
    free(array->data);
    return RCL_RET_OK;
}

/* ---- The node */

static const char *error = "";
static char remapped[3][2][64]; /* FROM:=TO */

static const char *name_of(const char *name)
{
    for (size_t i = 0; i < 3; i++)
        if (strcmp(remapped[i][0], name) == 0)
            return remapped[i][1];
    return name;
}

rcl_ret_t rcl_init(int argc, char const *const *argv, const rcl_init_options_t *options,
                   rcl_context_t *context)
{
    size_t count = 0;
    (void)options;
    (void)context;
    passed_s();
    robot.next_ns = now_ns() + PERIOD_NS;
    for (int i = 2; i < argc; i++) {
        const char *assign = strstr(argv[i], ":=");
        if (strcmp(argv[i - 1], "-r") != 0)
            continue;
        if (assign == NULL || count == 3) {
            error = "Couldn't parse remap rule";
            return RCL_RET_INVALID_ROS_ARGS;
        }
        snprintf(remapped[count][0], 64, "%.*s", (int)(assign - argv[i]), argv[i]);
        snprintf(remapped[count++][1], 64, "%s", assign + 2);
    }
    return RCL_RET_OK;
}

rcl_ret_t rcl_node_init(rcl_node_t *node, const char *name, const char *space,
                        rcl_context_t *context, const rcl_node_options_t *options)
{
    const char *new_name = name_of("__node");
    (void)space;
    (void)context;
    (void)options;
    snprintf(node->name, sizeof node->name, "/%s",
             strcmp(new_name, "__node") == 0 ? name : new_name);
    return RCL_RET_OK;
}

rcl_ret_t rcl_subscription_init(rcl_subscription_t *subscription, const rcl_node_t *node,
                                const rosidl_message_type_support_t *type, const char *topic,
                                const rcl_subscription_options_t *options)
{
    (void)node;
    (void)options;
    subscription->type = type;
    robot.simulated = robot.simulated || type == &fake_rosgraph_msgs_Clock;
    snprintf(subscription->topic, sizeof subscription->topic, "%s%s", topic[0] == '/' ? "" : "/",
             name_of(topic));
    return RCL_RET_OK;
}

rcl_ret_t rcl_publisher_init(rcl_publisher_t *publisher, const rcl_node_t *node,
                             const rosidl_message_type_support_t *type, const char *topic,
                             const rcl_publisher_options_t *options)
{
    (void)node;
    (void)options;
    if (type == &fake_geometry_msgs_TwistStamped)
        robot.stamped = true;
    snprintf(publisher->topic, sizeof publisher->topic, "%s%s",
             topic[0] == '/' || topic[0] == '~' ? "" : "/", name_of(topic));
    return RCL_RET_OK;
}

rcl_ret_t rcl_publisher_get_subscription_count(const rcl_publisher_t *publisher, size_t *count)
{
    (void)publisher;
    *count = 1;
    return RCL_RET_OK;
}

rcl_ret_t rcl_guard_condition_init(rcl_guard_condition_t *condition, rcl_context_t *context,
                                   rcl_guard_condition_options_t options)
{
    (void)context;
    (void)options;
    return pipe(condition->ends) == 0 ? RCL_RET_OK : RCL_RET_ERROR;
}

rcl_ret_t rcl_trigger_guard_condition(rcl_guard_condition_t *condition)
{
    return write(condition->ends[1], "", 1) == 1 ? RCL_RET_OK : RCL_RET_ERROR;
}

rcl_ret_t rcl_wait_set_clear(rcl_wait_set_t *set)
{
    set->count = set->service_count = 0;
    return RCL_RET_OK;
}

rcl_ret_t rcl_wait_set_add_subscription(rcl_wait_set_t *set, const rcl_subscription_t *subscription,
                                        size_t *index)
{
    (void)index;
    set->subscriptions[set->count++] = subscription;
    return RCL_RET_OK;
}

rcl_ret_t rcl_wait_set_add_service(rcl_wait_set_t *set, const rcl_service_t *service, size_t *index)
{
    (void)index;
    set->services[set->service_count++] = service;
    return RCL_RET_OK;
}

rcl_ret_t rcl_wait_set_add_guard_condition(rcl_wait_set_t *set,
                                           const rcl_guard_condition_t *condition, size_t *index)
{
    (void)index;
    set->guard_conditions[0] = condition;
    return RCL_RET_OK;
}

const char *rcl_node_get_name(const rcl_node_t *node)
{
    return node->name + 1;
}

const char *rcl_node_get_namespace(const rcl_node_t *node)
{
    (void)node;
    return "/";
}

const char *rcl_node_get_fully_qualified_name(const rcl_node_t *node)
{
    return node->name;
}

const char *rcl_subscription_get_topic_name(const rcl_subscription_t *subscription)
{
    return subscription->topic;
}

const char *rcl_publisher_get_topic_name(const rcl_publisher_t *publisher)
{
    return publisher->topic;
}

rcl_error_string_t rcl_get_error_string(void)
{
    rcl_error_string_t text;
    memset(&text, 0, sizeof text);
    snprintf(text.str, sizeof text.str, "%s", error);
    return text;
}

bool rosidl_runtime_c__String__assign(rosidl_runtime_c__String *string, const char *text)
{
    free(string->data);
    string->data = strdup(text);
    return string->data != NULL;
}

/* ---- Parameters: another node sets one, as FAKE_ROS_SET says ("pace=0.3"), after the time of the
 * fault "set" */

rcl_ret_t rcl_service_init(rcl_service_t *service, const rcl_node_t *node,
                           const rosidl_service_type_support_t *type, const char *name,
                           const rcl_service_options_t *options)
{
    (void)node;
    (void)type;
    (void)options;
    snprintf(service->name, sizeof service->name, "%s", name);
    return RCL_RET_OK;
}

rcl_ret_t rcl_take_request(const rcl_service_t *service, rmw_request_id_t *id, void *request)
{
    static bool sent = false;
    static rcl_interfaces__msg__Parameter parameter;
    rcl_interfaces__msg__Parameter__Sequence *parameters =
        &((rcl_interfaces__srv__SetParameters_Request *)request)->parameters;
    const char *text = getenv("FAKE_ROS_SET"), *value = text != NULL ? strchr(text, '=') : NULL;
    (void)id;
    if (strcmp(service->name, "~/change_state") == 0)
        return fake_lifecycle_request(request, has) ? RCL_RET_OK : RCL_RET_ERROR;
    if (sent || value == NULL || !has("set") || strcmp(service->name, "~/set_parameters") != 0)
        return RCL_RET_ERROR;
    sent = true;
    parameter.name.data = strndup(text, (size_t)(value - text));
    parameter.value.type = strcmp(value + 1, "true") == 0 ? 1 : 3;
    parameter.value.bool_value = parameter.value.type == 1;
    parameter.value.double_value = strtod(value + 1, NULL);
    parameters->data = &parameter;
    parameters->size = 1;
    return RCL_RET_OK;
}

rcl_ret_t rcl_send_response(const rcl_service_t *service, rmw_request_id_t *id, void *response)
{
    const rcl_interfaces__srv__SetParameters_Response *r =
        (const rcl_interfaces__srv__SetParameters_Response *)response;
    char line[400];
    (void)id;
    if (strcmp(service->name, "~/change_state") == 0)
        return RCL_RET_OK;
    snprintf(line, sizeof line, "set_parameters: %s",
             r->results.data[0].successful ? "successful" : r->results.data[0].reason.data);
    write_log(line);
    return RCL_RET_OK;
}

/* A parameter file has one line, NODE NAME VALUE, instead of YAML; the value is a number. */
rcl_params_t *rcl_yaml_node_struct_init(rcutils_allocator_t allocator)
{
    static rcl_params_t params;
    (void)allocator;
    return &params;
}

bool rcl_parse_yaml_file(const char *file, rcl_params_t *params)
{
    static char node[100], name[100], *nodes[] = { node }, *names[] = { name };
    static double number;
    static rcl_variant_t value = { NULL, NULL, &number, NULL };
    static rcl_node_params_t of_node = { names, &value, 1 };
    FILE *stream = fopen(file, "r");
    bool ok = stream != NULL && fscanf(stream, "%99s %99s %lf", node, name, &number) == 3;
    params->node_names = nodes;
    params->params = &of_node;
    params->num_nodes = 1;
    if (stream != NULL)
        fclose(stream);
    return ok;
}

void rcl_yaml_node_struct_fini(rcl_params_t *params)
{
    (void)params;
}

bool rosidl_runtime_c__float__Sequence__init(rosidl_runtime_c__float__Sequence *sequence,
                                             size_t size)
{
    sequence->data = (float *)calloc(size + 1, sizeof(float));
    sequence->size = size;
    return sequence->data != NULL;
}

void rosidl_runtime_c__float__Sequence__fini(rosidl_runtime_c__float__Sequence *sequence)
{
    free(sequence->data);
}

void rosidl_runtime_c__uint8__Sequence__fini(rosidl_runtime_c__uint8__Sequence *sequence)
{
    free(sequence->data);
}

#define SEQUENCE_INIT(type)                                              \
    bool type##__Sequence__init(type##__Sequence *sequence, size_t size) \
    {                                                                    \
        sequence->data = (type *)calloc(size + 1, sizeof(type));         \
        sequence->size = size;                                           \
        return sequence->data != NULL;                                   \
    }

SEQUENCE_INIT(rosidl_runtime_c__uint8)
SEQUENCE_INIT(rosidl_runtime_c__String)
SEQUENCE_INIT(rcl_interfaces__msg__ParameterValue)
SEQUENCE_INIT(rcl_interfaces__msg__Parameter)
SEQUENCE_INIT(rcl_interfaces__msg__SetParametersResult)
SEQUENCE_INIT(rcl_interfaces__msg__FloatingPointRange)
SEQUENCE_INIT(rcl_interfaces__msg__IntegerRange)
SEQUENCE_INIT(rcl_interfaces__msg__ParameterDescriptor)
SEQUENCE_INIT(geometry_msgs__msg__Point)
SEQUENCE_INIT(visualization_msgs__msg__Marker)
SEQUENCE_INIT(diagnostic_msgs__msg__DiagnosticStatus)
SEQUENCE_INIT(geometry_msgs__msg__TransformStamped)

bool diagnostic_msgs__msg__DiagnosticArray__init(diagnostic_msgs__msg__DiagnosticArray *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

const rosidl_message_type_support_t fake_diagnostic_msgs_DiagnosticArray = {
    "diagnostic_msgs/msg/DiagnosticArray", NULL, NULL
};

FAKE_SERVICE(rcl_interfaces, SetParameters)
FAKE_SERVICE(rcl_interfaces, SetParametersAtomically)
FAKE_SERVICE(rcl_interfaces, GetParameters)
FAKE_SERVICE(rcl_interfaces, GetParameterTypes)
FAKE_SERVICE(rcl_interfaces, DescribeParameters)
FAKE_SERVICE(rcl_interfaces, ListParameters)

bool rcl_interfaces__msg__ParameterEvent__init(rcl_interfaces__msg__ParameterEvent *event)
{
    memset(event, 0, sizeof *event);
    return true;
}

void rcl_interfaces__msg__ParameterEvent__fini(rcl_interfaces__msg__ParameterEvent *event)
{
    free(event->changed_parameters.data);
}

/* ---- Functions that do nothing */

#define ZERO(type, name)               \
    type name(void)                    \
    {                                  \
        type zero;                     \
        memset(&zero, 0, sizeof zero); \
        return zero;                   \
    }

ZERO(rcl_allocator_t, rcl_get_default_allocator)
ZERO(rcutils_allocator_t, rcutils_get_default_allocator)
ZERO(rcl_init_options_t, rcl_get_zero_initialized_init_options)
ZERO(rcl_context_t, rcl_get_zero_initialized_context)
ZERO(rcl_node_options_t, rcl_node_get_default_options)
ZERO(rcl_node_t, rcl_get_zero_initialized_node)
ZERO(rcl_subscription_t, rcl_get_zero_initialized_subscription)
ZERO(rcl_subscription_options_t, rcl_subscription_get_default_options)
ZERO(rcl_publisher_t, rcl_get_zero_initialized_publisher)
ZERO(rcl_publisher_options_t, rcl_publisher_get_default_options)
ZERO(rcl_service_t, rcl_get_zero_initialized_service)
ZERO(rcl_service_options_t, rcl_service_get_default_options)
ZERO(rcl_guard_condition_t, rcl_get_zero_initialized_guard_condition)
ZERO(rcl_guard_condition_options_t, rcl_guard_condition_get_default_options)
ZERO(rcl_wait_set_t, rcl_get_zero_initialized_wait_set)
ZERO(rcl_topic_endpoint_info_array_t, rcl_get_zero_initialized_topic_endpoint_info_array)
ZERO(rcutils_string_array_t, rcutils_get_zero_initialized_string_array)

#define SUCCEEDS(name, ...)     \
    rcl_ret_t name(__VA_ARGS__) \
    {                           \
        return RCL_RET_OK;      \
    }

SUCCEEDS(rcl_init_options_init, rcl_init_options_t *o, rcl_allocator_t a)
SUCCEEDS(rcl_init_options_fini, rcl_init_options_t *o)
SUCCEEDS(rcl_shutdown, rcl_context_t *c)
SUCCEEDS(rcl_context_fini, rcl_context_t *c)
SUCCEEDS(rcl_node_fini, rcl_node_t *n)
SUCCEEDS(rcl_subscription_fini, rcl_subscription_t *s, rcl_node_t *n)
SUCCEEDS(rcl_publisher_fini, rcl_publisher_t *p, rcl_node_t *n)
SUCCEEDS(rcl_service_fini, rcl_service_t *s, rcl_node_t *n)
SUCCEEDS(rcl_publisher_wait_for_all_acked, const rcl_publisher_t *p, int64_t ns)
SUCCEEDS(rcl_guard_condition_fini, rcl_guard_condition_t *g)
SUCCEEDS(rcl_wait_set_init, rcl_wait_set_t *s, size_t a, size_t b, size_t c, size_t d, size_t e,
         size_t f, rcl_context_t *x, rcl_allocator_t y)
SUCCEEDS(rcl_wait_set_fini, rcl_wait_set_t *s)

void rcl_reset_error(void) {}
void rcutils_reset_error(void) {}

bool geometry_msgs__msg__Twist__init(geometry_msgs__msg__Twist *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool geometry_msgs__msg__TwistStamped__init(geometry_msgs__msg__TwistStamped *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool geometry_msgs__msg__PointStamped__init(geometry_msgs__msg__PointStamped *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool visualization_msgs__msg__MarkerArray__init(visualization_msgs__msg__MarkerArray *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool std_msgs__msg__Empty__init(std_msgs__msg__Empty *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool sensor_msgs__msg__Joy__init(sensor_msgs__msg__Joy *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool std_msgs__msg__String__init(std_msgs__msg__String *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool rosgraph_msgs__msg__Clock__init(rosgraph_msgs__msg__Clock *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool sensor_msgs__msg__LaserScan__init(sensor_msgs__msg__LaserScan *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool sensor_msgs__msg__Image__init(sensor_msgs__msg__Image *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool sensor_msgs__msg__CompressedImage__init(sensor_msgs__msg__CompressedImage *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool std_msgs__msg__Bool__init(std_msgs__msg__Bool *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool sensor_msgs__msg__BatteryState__init(sensor_msgs__msg__BatteryState *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool sensor_msgs__msg__Imu__init(sensor_msgs__msg__Imu *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

bool nav_msgs__msg__Odometry__init(nav_msgs__msg__Odometry *m)
{
    memset(m, 0, sizeof *m);
    return true;
}

/* ---- Types of messages, and the introspection of some of them */

static const rosidl_message_type_support_t *itself(const rosidl_message_type_support_t *support,
                                                   const char *identifier)
{
    return strcmp(identifier, "rosidl_typesupport_introspection_c") == 0 ? support : NULL;
}

static void zero_bool(void *message, enum rosidl_runtime_c__message_initialization how)
{
    (void)how;
    memset(message, 0, sizeof(std_msgs__msg__Bool));
}

static void zero_string(void *message, enum rosidl_runtime_c__message_initialization how)
{
    (void)how;
    memset(message, 0, sizeof(std_msgs__msg__String));
}

static void zero_twist(void *message, enum rosidl_runtime_c__message_initialization how)
{
    (void)how;
    memset(message, 0, sizeof(geometry_msgs__msg__Twist));
}

#define MEMBER(name, type, of, owner)                                  \
    { .name_ = #name,                                                  \
      .type_id_ = rosidl_typesupport_introspection_c__ROS_TYPE_##type, \
      .members_ = of,                                                  \
      .offset_ = (uint32_t)offsetof(owner, name) }

static const rosidl_typesupport_introspection_c__MessageMember members_of_bool[] = { MEMBER(
    data, BOOLEAN, NULL, std_msgs__msg__Bool) };
static const rosidl_typesupport_introspection_c__MessageMembers bool_type = {
    "std_msgs__msg", "Bool", 1, sizeof(std_msgs__msg__Bool), members_of_bool, zero_bool
};

static const rosidl_typesupport_introspection_c__MessageMember members_of_string[] = { MEMBER(
    data, STRING, NULL, std_msgs__msg__String) };
static const rosidl_typesupport_introspection_c__MessageMembers string_type = {
    "std_msgs__msg", "String", 1, sizeof(std_msgs__msg__String), members_of_string, zero_string
};

static const rosidl_typesupport_introspection_c__MessageMember members_of_vector[] = {
    MEMBER(x, DOUBLE, NULL, geometry_msgs__msg__Vector3),
    MEMBER(y, DOUBLE, NULL, geometry_msgs__msg__Vector3),
    MEMBER(z, DOUBLE, NULL, geometry_msgs__msg__Vector3),
};
static const rosidl_typesupport_introspection_c__MessageMembers vector_type = {
    "geometry_msgs__msg", "Vector3", 3, sizeof(geometry_msgs__msg__Vector3), members_of_vector, NULL
};
static const rosidl_message_type_support_t vector = { "geometry_msgs/msg/Vector3", &vector_type,
                                                      itself };

static const rosidl_typesupport_introspection_c__MessageMember members_of_twist[] = {
    MEMBER(linear, MESSAGE, &vector, geometry_msgs__msg__Twist),
    MEMBER(angular, MESSAGE, &vector, geometry_msgs__msg__Twist),
};
static const rosidl_typesupport_introspection_c__MessageMembers twist_type = {
    "geometry_msgs__msg", "Twist",   2, sizeof(geometry_msgs__msg__Twist),
    members_of_twist,     zero_twist
};

const rosidl_message_type_support_t fake_std_msgs_Bool = { "std_msgs/msg/Bool", &bool_type,
                                                           itself };
const rosidl_message_type_support_t fake_std_msgs_String = { "std_msgs/msg/String", &string_type,
                                                             itself };
const rosidl_message_type_support_t fake_geometry_msgs_Twist = { "geometry_msgs/msg/Twist",
                                                                 &twist_type, itself };

#define OPAQUE(variable, name) const rosidl_message_type_support_t variable = { name, NULL, NULL };

OPAQUE(fake_geometry_msgs_TwistStamped, "geometry_msgs/msg/TwistStamped")
OPAQUE(fake_geometry_msgs_PointStamped, "geometry_msgs/msg/PointStamped")
OPAQUE(fake_sensor_msgs_Joy, "sensor_msgs/msg/Joy")
OPAQUE(fake_std_msgs_Empty, "std_msgs/msg/Empty")
OPAQUE(fake_visualization_msgs_MarkerArray, "visualization_msgs/msg/MarkerArray")
OPAQUE(fake_tf2_msgs_TFMessage, "tf2_msgs/msg/TFMessage")
OPAQUE(fake_nav_msgs_Odometry, "nav_msgs/msg/Odometry")
OPAQUE(fake_sensor_msgs_Image, "sensor_msgs/msg/Image")
OPAQUE(fake_sensor_msgs_CompressedImage, "sensor_msgs/msg/CompressedImage")
OPAQUE(fake_sensor_msgs_BatteryState, "sensor_msgs/msg/BatteryState")
OPAQUE(fake_sensor_msgs_LaserScan, "sensor_msgs/msg/LaserScan")
OPAQUE(fake_sensor_msgs_Imu, "sensor_msgs/msg/Imu")
OPAQUE(fake_rosgraph_msgs_Clock, "rosgraph_msgs/msg/Clock")
OPAQUE(fake_rcl_interfaces_ParameterEvent, "rcl_interfaces/msg/ParameterEvent")
