/* Tests without ROS how the host for ROS 2 handles messages: timestamps, conversions, and the
 * driver with core/robot.h on a line in memory, in virtual time. */
#include "../drivers/check.h"

#include "core/robot.h"
#include "hal/fake/fake.h"
#include "hosts/ros/device.h"
#include "hosts/ros/frames.h"
#include "hosts/ros/joy.h"
#include "hosts/ros/odometry.h"
#include "hosts/ros/operated.h"
#include "hosts/ros/parameters.h"
#include "hosts/ros/sim_clock.h"
#include "hosts/ros/stamps.h"

#include <frob/ros.h>

#include <stdlib.h>
#include <string.h>

#define MS INT64_C(1000000)
#define S INT64_C(1000000000)
#define PATIENCE (200 * MS)

/* ---- Stamps */

static enum stamps_verdict judge(struct stamps *s, int64_t stamp_ns, int64_t arrived_ns)
{
    int64_t by_ns;
    return stamps_judge(s, stamp_ns, arrived_ns, PATIENCE, &by_ns);
}

/* Messages every 20 ms for some seconds, from a clock that is `ahead_ns` ahead of ours. Returns the
 * last verdict. */
static enum stamps_verdict regular(struct stamps *s, int64_t from_ns, double seconds,
                                   int64_t ahead_ns)
{
    enum stamps_verdict verdict = STAMPS_GOOD;
    for (int64_t t = from_ns; t <= from_ns + (int64_t)(seconds * 1e9); t += 20 * MS)
        verdict = judge(s, t + ahead_ns, t);
    return verdict;
}

static void test_stamps(void)
{
    struct stamps s;
    int64_t by_ns;

    memset(&s, 0, sizeof s);
    check(regular(&s, 0, 10, 100 * S) == STAMPS_GOOD, "a sender's clock may differ by any amount");
    check(stamps_judge(&s, 110 * S + 20 * MS, 10 * S + 120 * MS, PATIENCE, &by_ns) == STAMPS_GOOD,
          "a message may be late by less than the patience");
    check_near((double)by_ns * 1e-6, 100, 6, "its delay is known");
    check(judge(&s, 110 * S + 40 * MS, 10 * S + 300 * MS) == STAMPS_OLD,
          "a message that waited longer is old");
    check(judge(&s, 110 * S + 320 * MS, 10 * S + 320 * MS) == STAMPS_GOOD,
          "the next one may be good again");

    memset(&s, 0, sizeof s);
    regular(&s, 0, 10, 0);
    for (int i = 0; i < 200; i++)
        check_failures +=
            judge(&s, 10 * S + (i + 1) * 20 * MS, 12 * S + (i + 1) * 20 * MS) != STAMPS_OLD;
    check(check_failures == 0, "messages that are always late never count");

    memset(&s, 0, sizeof s);
    regular(&s, 0, 10, 0);
    check(judge(&s, 5 * S, 10 * S + 20 * MS) == STAMPS_BACK, "a single stamp may jump back");
    check(judge(&s, 10 * S + 40 * MS, 10 * S + 40 * MS) == STAMPS_GOOD, "it changes nothing");
    check(judge(&s, 15 * S, 10 * S + 60 * MS) == STAMPS_AHEAD, "a single stamp may jump ahead");
    check(judge(&s, 10 * S + 80 * MS, 10 * S + 80 * MS) == STAMPS_GOOD, "it changes nothing");

    check(regular(&s, 10 * S + 100 * MS, 0.9, -3 * S) == STAMPS_BACK,
          "a clock that was set back does not count at once");
    check(regular(&s, 11 * S + 20 * MS, 0.1, -3 * S) == STAMPS_GOOD, "it counts after a second");
    check(regular(&s, 11 * S + 140 * MS, 0.9, 3 * S) == STAMPS_AHEAD,
          "a clock that was set ahead does not count at once");
    check(regular(&s, 12 * S + 60 * MS, 0.2, 3 * S) == STAMPS_GOOD, "it counts after a second");

    memset(&s, 0, sizeof s);
    judge(&s, 0 + 1, 500 * MS);
    check(judge(&s, 20 * MS, 500 * MS) == STAMPS_GOOD, "the first message may be the late one");
    check(regular(&s, 520 * MS, 0.4, 0) == STAMPS_GOOD, "later ones have the shorter way");

    memset(&s, 0, sizeof s);
    for (int64_t t = 0; t < 3600 * S; t += 20 * MS)
        if (judge(&s, S + t - t / 5000, t) != STAMPS_GOOD)
            check_failures++;
    check(check_failures == 0, "a clock that is slow by one part in 5000 counts for an hour");
    check(judge(&s, 0, 3600 * S) == STAMPS_GOOD, "a message without a stamp is good");
}

/* ---- Odometry */

static struct ros_odometry facing(double heading)
{
    struct ros_odometry o;
    memset(&o, 0, sizeof o);
    o.head.size = (uint32_t)sizeof o;
    o.head.kind = ROS_ODOMETRY;
    o.rotation[2] = sin(heading / 2);
    o.rotation[3] = cos(heading / 2);
    return o;
}

static void test_odometry(void)
{
    struct ros_odometry o = facing(2.0);
    struct ros_motion motion;
    o.x_m = 1.5;
    o.y_m = -2.5;
    o.speed_m_s = 0.3;
    o.turning_rad_s = -0.4;
    check(ros_motion_of(&o, &motion) == NULL, "odometry is converted");
    check_near(motion.x_m, 1.5, 0, "x");
    check_near(motion.y_m, -2.5, 0, "y");
    check_near(motion.heading_rad, 2.0, 1e-12, "the heading is the yaw of the quaternion");
    check_near(motion.speed_m_s, 0.3, 0, "speed");
    check_near(motion.turning_rad_s, -0.4, 0, "turn rate, positive to the left");
    o = facing(-3.0);
    ros_motion_of(&o, &motion);
    check_near(motion.heading_rad, -3.0, 1e-12, "the heading is from -pi to pi");
    /* A roll by 0.2 and then a yaw by 1: the yaw does not change. */
    o.rotation[0] = sin(0.1) * cos(0.5);
    o.rotation[1] = sin(0.1) * sin(0.5);
    o.rotation[2] = cos(0.1) * sin(0.5);
    o.rotation[3] = cos(0.1) * cos(0.5);
    ros_motion_of(&o, &motion);
    check_near(motion.heading_rad, 1.0, 1e-12, "a robot on a slope keeps its heading");

    o = facing(0);
    o.x_m = NAN;
    check(ros_motion_of(&o, &motion) != NULL, "a position that is not a number is rejected");
    o = facing(0);
    o.turning_rad_s = INFINITY;
    check(ros_motion_of(&o, &motion) != NULL, "an infinite speed is rejected");
    o = facing(0);
    o.rotation[3] = 0;
    check(ros_motion_of(&o, &motion) != NULL, "a quaternion of zeros is rejected");
    o = facing(0);
    o.rotation[0] = NAN;
    check(ros_motion_of(&o, &motion) != NULL, "a quaternion of NaN is rejected");
}

/* ---- Lidars and inertial measurement units */

static struct ros_scan a_scan(void)
{
    static struct ros_scan m;
    memset(&m, 0, sizeof m);
    m.head.kind = ROS_SCAN;
    m.count = 4;
    m.head.size = (uint32_t)(offsetof(struct ros_scan, ranges_m) + 4 * sizeof m.ranges_m[0]);
    m.first_rad = -1.5;
    m.step_rad = 1.0;
    m.nearest_m = 0.25;
    m.farthest_m = 8.0;
    m.ranges_m[0] = 1.0f;
    m.ranges_m[1] = NAN;
    m.ranges_m[2] = INFINITY;
    m.ranges_m[3] = -INFINITY;
    return m;
}

static void test_scan(void)
{
    struct ros_seat seat = { 0.1, 0.2, 0.5, false };
    struct ros_scan m = a_scan();
    struct frob_scan scan;
    double room[ROS_RAYS_MOST];
    check(ros_scan_of(&m, &seat, room, &scan) == NULL, "a scan is converted");
    check(scan.count == 4 && scan.ranges_m[0] == 1.0, "distances");
    check(isnan(scan.ranges_m[1]), "a ray of NaN is unknown");
    check(isinf(scan.ranges_m[2]), "a ray of infinity has nothing in range");
    check_near(scan.ranges_m[3], 0.25, 0, "minus infinity is an object at the smallest distance");
    check_near(scan.first_rad, -1.0, 1e-12, "bearings are turned with the lidar");
    check_near(scan.x_m, 0.1, 0, "the lidar is not at the centre");

    m.first_rad = 1.5;
    m.step_rad = -1.0;
    ros_scan_of(&m, &seat, room, &scan);
    check_near(scan.first_rad, -1.0, 1e-12, "a clockwise scan begins at its other end");
    check_near(scan.step_rad, 1.0, 0, "its rays are in the other order");
    check_near(scan.ranges_m[3], 1.0, 0, "as are its distances");

    m = a_scan();
    seat.is_upside_down = true;
    ros_scan_of(&m, &seat, room, &scan);
    check_near(scan.first_rad, -1.0, 1e-12, "a lidar that is upside down scans the other way");
    check_near(scan.ranges_m[0], 0.25, 0, "its last ray is the rightmost one");
    check_near(scan.ranges_m[3], 1.0, 0, "and its first ray the leftmost one");

    m = a_scan();
    m.step_rad = 0.0;
    check(ros_scan_of(&m, &seat, room, &scan) != NULL, "a step of 0 is rejected");
    m.step_rad = 3.0;
    check(ros_scan_of(&m, &seat, room, &scan) != NULL, "more than a turn is rejected");
    m = a_scan();
    m.first_rad = NAN;
    check(ros_scan_of(&m, &seat, room, &scan) != NULL, "an angle of NaN is rejected");
    m = a_scan();
    m.farthest_m = 0.0;
    check(ros_scan_of(&m, &seat, room, &scan) != NULL, "a range without a maximum is rejected");
    m = a_scan();
    m.count = 0;
    check(ros_scan_of(&m, &seat, room, &scan) != NULL, "a scan without rays is rejected");
}

/* ---- Frames */

/* A pose on the floor, or at a height. */
static struct frames_pose at(double x_m, double y_m, double z_m, double heading_rad)
{
    const struct frames_pose pose = { { x_m, y_m, z_m },
                                      { 0.0, 0.0, sin(heading_rad / 2), cos(heading_rad / 2) } };
    return pose;
}

static bool put(struct frames *frames, const char *parent, const char *name,
                struct frames_pose pose)
{
    return frames_put(frames, parent, name, &pose, true, 0) == NULL;
}

static void test_frames(void)
{
    static struct frames f;
    const double half_pi = acos(0.0), point[3] = { 1.0, 0.0, 0.0 };
    struct frames_pose pose = at(0.0, 0.0, 0.0, 0.0);
    double found[3];
    check(frames_find(&f, "base_link", "base_link", 0, &pose), "a frame is at its own place");
    check(!frames_find(&f, "base_link", "laser", 0, &pose), "an unknown frame is not found");
    put(&f, "base_footprint", "base_link", at(0.0, 0.0, 0.1, 0.0));
    put(&f, "base_link", "mast", at(0.5, 0.0, 0.3, half_pi));
    check(put(&f, "/mast", "/laser", at(0.25, 0.0, 0.0, half_pi)),
          "names may begin with a slash, as in ROS 1");
    check(frames_find(&f, "base_footprint", "laser", 0, &pose), "a frame is found");
    check_near(pose.at_m[0], 0.5, 1e-12, "ahead");
    check_near(pose.at_m[1], 0.25, 1e-12, "on the left");
    check_near(pose.at_m[2], 0.4, 1e-12, "and above");
    frames_point(&pose, point, found);
    check_near(found[0], -0.5, 1e-12, "a point is turned and moved");
    check_near(found[1], 0.25, 1e-12, "in both directions");
    check(frames_find(&f, "laser", "base_footprint", 0, &pose), "the way back is found too");
    check_near(pose.at_m[0], 0.5, 1e-12, "with the inverse transform");
    check_near(pose.at_m[1], 0.25, 1e-12, "in both directions");
    put(&f, "base_footprint", "wheel", at(-1.0, 0.0, 0.0, 0.0));
    check(frames_find(&f, "wheel", "laser", 0, &pose), "and the way between two branches");
    check_near(pose.at_m[0], 1.5, 1e-12, "through the frame that they share");

    check(!put(&f, "base_link", "laser", at(NAN, 0, 0, 0)), "a position of NaN is rejected");
    pose = at(0, 0, 0, 0);
    pose.rotation[3] = 0.0;
    check(!put(&f, "base_link", "laser", pose), "and so is a quaternion of zeros");
    check(!put(&f, "laser", "laser", at(0, 0, 0, 0)), "and a frame in itself");
    put(&f, "b", "a", at(0, 0, 0, 0));
    put(&f, "a", "b", at(0, 0, 0, 0));
    check(!frames_find(&f, "base_link", "a", 0, &pose), "frames in a circle are not found");

    pose = at(2, 0, 0, 0);
    frames_put(&f, "odom", "base_footprint", &pose, false, 0);
    check(frames_find(&f, "odom", "base_link", S, &pose), "a moving frame is found");
    check(!frames_find(&f, "odom", "base_link", 3 * S, &pose), "but only for two seconds");
    check(frames_find(&f, "base_link", "laser", 3 * S, &pose), "fixed ones remain");
}

static void test_seat(void)
{
    struct frames_pose pose = at(0.1, -0.2, 0.5, 2.0);
    struct ros_seat seat;
    check(frames_seat(&pose, &seat) && !seat.is_upside_down, "a lidar is level");
    check_near(seat.x_m, 0.1, 0, "ahead");
    check_near(seat.y_m, -0.2, 0, "on the right");
    check_near(seat.heading_rad, 2.0, 1e-12, "its direction");
    /* Half a turn about an axis at 1 rad. */
    pose.rotation[0] = cos(1.0);
    pose.rotation[1] = sin(1.0);
    pose.rotation[2] = pose.rotation[3] = 0.0;
    check(frames_seat(&pose, &seat) && seat.is_upside_down, "a lidar may be upside down");
    check_near(seat.heading_rad, 2.0, 1e-12, "it looks into a direction too");
    pose.rotation[0] = sin(0.15);
    pose.rotation[1] = 0.0;
    pose.rotation[3] = cos(0.15);
    check(!frames_seat(&pose, &seat), "a tilted lidar is rejected");
}

static void test_imu(void)
{
    struct ros_measurements sums;
    struct frob_imu reading;
    struct ros_imu m;
    memset(&sums, 0, sizeof sums);
    memset(&m, 0, sizeof m);
    m.rate_radps[2] = 1.0;
    m.acceleration_mps2[2] = 9.81;
    check(ros_imu_check(&m) == NULL, "a measurement without an orientation is usable");
    ros_imu_add(&sums, &m);
    m.rate_radps[2] = 2.0;
    m.has_rotation = true;
    check(ros_imu_check(&m) != NULL, "an orientation of zeros is rejected");
    m.rotation[2] = sin(0.5);
    m.rotation[3] = cos(0.5);
    check(ros_imu_check(&m) == NULL, "an orientation is usable");
    ros_imu_add(&sums, &m);
    reading = ros_imu_mean(&sums, 5);
    check_near(reading.rate_radps[2], 1.5, 1e-12, "rates are means");
    check_near(reading.acceleration_mps2[2], 9.81, 1e-12, "and so are accelerations");
    check_near(reading.heading_rad, 1.0, 1e-12, "the heading is that of the last measurement");
    check(reading.number == 2 && reading.taken_ns == 5, "its number and time");
    m.rate_radps[0] = NAN;
    check(ros_imu_check(&m) != NULL, "a rate of NaN is rejected");
}

static void test_imu_frame(void)
{
    const double quarter = sqrt(0.5);
    double heading_rad;
    struct ros_imu m;
    memset(&m, 0, sizeof m);
    /* The unit looks to the left. The robot looks in the direction 0.3 rad, so the unit in 0.3 rad
     * and a quarter of a turn. */
    m.mounting[2] = m.mounting[3] = quarter;
    m.rotation[2] = sin((0.3 + acos(0.0)) / 2);
    m.rotation[3] = cos((0.3 + acos(0.0)) / 2);
    m.acceleration_mps2[0] = 1.0;
    m.rate_radps[1] = 2.0;
    m.rate_radps[2] = 3.0;
    ros_imu_turn(&m);
    check_near(m.acceleration_mps2[0], 0.0, 1e-12, "an acceleration to the left is not ahead");
    check_near(m.acceleration_mps2[1], 1.0, 1e-12, "but to the left");
    check_near(m.rate_radps[0], -2.0, 1e-12, "a rotation around its left is around the back");
    check_near(m.rate_radps[2], 3.0, 1e-12, "the turn rate is the same");
    check(ros_yaw_of(m.rotation, &heading_rad), "the orientation is a rotation");
    check_near(heading_rad, 0.3, 1e-12, "it is that of the robot");
    /* A unit that is mounted upside down, with its x-axis ahead. */
    memset(&m, 0, sizeof m);
    m.mounting[0] = 1.0;
    m.rotation[0] = cos(0.15);
    m.rotation[1] = sin(0.15);
    m.rate_radps[2] = -3.0;
    m.acceleration_mps2[2] = -9.81;
    ros_imu_turn(&m);
    check_near(m.rate_radps[2], 3.0, 1e-12, "a unit upside down measures the opposite turn rate");
    check_near(m.acceleration_mps2[2], 9.81, 1e-12, "and the opposite gravity");
    check(ros_yaw_of(m.rotation, &heading_rad), "the orientation is a rotation");
    check_near(heading_rad, 0.3, 1e-12, "without the turn of its mounting");
}

/* ---- Parameters */

static struct parameters node_parameters(void)
{
    static const struct frob_value number = { .kind = FROB_FLOAT, .offset = 0 };
    static const struct frob_value whole = { .kind = FROB_INT, .offset = sizeof(double) };
    static const struct frob_param params[] = { { "kTurn", "1/m", &number },
                                                { "count", "1", &whole } };
    static const struct frob_control controls[] = {
        { .kind = FROB_BUTTON, .label = "go" },
        { .kind = FROB_KNOB, .label = "pace", .unit = "m/s", .least = 0, .most = 1, .first = 0.5 },
        { .kind = FROB_TOGGLE, .label = "lamp", .unit = "", .most = 1 },
        { .kind = FROB_KNOB, .label = "kTurn", .unit = "1", .least = 0, .most = 1, .first = 0.5 },
    };
    static const struct {
        double number;
        int32_t whole;
    } values = { 4.0, 7 };
    static const struct frob_program program = {
        .console = controls, .control_count = 4, .params = params, .param_count = 2
    };
    struct parameters result;
    check(parameters_of(&result, &program, &values, true), "there is memory for parameters");
    return result;
}

/* Whether the parameter accepts the request, and otherwise gives this reason. */
static bool answers(const struct parameters *parameters, const char *name,
                    struct parameter_request request, const char *reason)
{
    char why[1000] = "";
    double value = -1.0;
    bool ok = parameters_convert(parameters, parameters_find(parameters, name), name, &request,
                                 &value, why, sizeof why);
    if (reason == NULL)
        return ok && value == (request.type == PARAMETER_BOOL      ? (double)request.truth
                               : request.type == PARAMETER_INTEGER ? (double)request.integer
                                                                   : request.number);
    if (ok || strcmp(why, reason) != 0)
        printf("     found \"%s\"\n", why);
    return !ok && strcmp(why, reason) == 0;
}

static void test_parameters(void)
{
    const struct parameters p = node_parameters();
    const struct parameter_request half = { PARAMETER_DOUBLE, false, 0, 0.25 };
    const struct parameter_request one = { PARAMETER_INTEGER, false, 1, 0.0 };
    const struct parameter_request large = { PARAMETER_DOUBLE, false, 0, 3.0 };
    const struct parameter_request nan = { PARAMETER_DOUBLE, false, 0, NAN };
    const struct parameter_request yes = { PARAMETER_BOOL, true, 0, 0.0 };
    const struct parameter_request text = { 4, false, 0, 0.0 };
    char reason[1000], description[100];
    double value;
    check(p.count == 5, "buttons are not parameters, and a parameter hides a knob");
    check(parameters_find(&p, "kTurn")->value == 4.0 && parameters_find(&p, "count")->value == 7.0,
          "they have the values of the run");
    check(parameters_find(&p, "pace")->value == 0.5 && !parameters_find(&p, "lamp")->is_fixed,
          "knobs and toggles have their initial values");
    check(parameters_find(&p, "use_sim_time")->value == 1.0, "use_sim_time");
    check(answers(&p, "pace", half, NULL), "a knob can be set");
    check(answers(&p, "pace", one, NULL), "also to a whole number");
    check(answers(&p, "lamp", yes, NULL), "a toggle can be set");
    check(answers(&p, "pace", large, "`pace` must be a number from 0 to 1 m/s, not 3"),
          "a value out of range is refused");
    check(answers(&p, "pace", nan, "`pace` must be a number from 0 to 1 m/s, not nan"),
          "and so is NaN");
    check(answers(&p, "pace", yes, "`pace` has the type double, but the value has the type bool"),
          "a value of another type is refused");
    check(answers(&p, "lamp", text, "`lamp` has the type bool, but the value has the type string"),
          "and so is a text");
    check(answers(&p, "kTurn", half,
                  "`kTurn` is fixed during a run: restart the node with `--ros-args -p "
                  "kTurn:=VALUE`, or make it a knob on the program's console"),
          "a parameter of the program is fixed");
    check(answers(&p, "speed", half,
                  "the node has no parameter `speed`; its parameters are `kTurn`, `count`, `pace`, "
                  "`lamp`, `use_sim_time`"),
          "an unknown parameter is refused");
    check(parameters_read(&p, parameters_find(&p, "pace"), "0.75", &value, reason, sizeof reason) &&
              value == 0.75,
          "an argument sets a knob");
    check(!parameters_read(&p, parameters_find(&p, "pace"), "fast", &value, reason, sizeof reason),
          "unless it is not a number");
    parameters_describe(parameters_find(&p, "pace"), description, sizeof description);
    check(strcmp(description, "m/s; knob on the program's console") == 0, "the unit is described");
    free(p.each);
}

/* ---- The joystick */

/* The input of a program with a hold, a knob and a button. */
struct held {
    bool is_held, is_pressed;
    double pace;
};

static const struct frob_program *held_program(void)
{
    static const struct frob_value held = { .kind = FROB_BOOL, .offset = 0 };
    static const struct frob_value pace = { .kind = FROB_FLOAT,
                                            .offset = offsetof(struct held, pace) };
    static const struct frob_value pressed = { .kind = FROB_SUM,
                                               .offset = offsetof(struct held, is_pressed) };
    static const struct frob_control controls[] = {
        { .kind = FROB_HOLD, .label = "drive slowly", .value = &held },
        { .kind = FROB_KNOB, .label = "pace", .most = 1, .first = 0.25, .value = &pace },
        { .kind = FROB_BUTTON, .label = "2nd go!", .value = &pressed },
    };
    static const struct frob_program program = { .console = controls, .control_count = 3 };
    return &program;
}

static int settings_of(const char *setting)
{
    char text[64], *argv[] = { text, text, text, NULL };
    static char name[] = "held", set[] = "--set";
    argv[0] = name;
    argv[1] = set;
    snprintf(text, sizeof text, "%s", setting);
    return joy_settings(3, argv, held_program());
}

static void joystick(struct joy *joy, float axis, bool is_down, struct held *input, int64_t now_ns)
{
    char why[ROS_REASON];
    struct ros_joy m;
    memset(&m, 0, sizeof m);
    m.axis_count = m.button_count = 2;
    m.axes[1] = axis;
    m.is_down[0] = is_down;
    check(joy_check(&m, held_program(), why, sizeof why) == NULL, "a message counts");
    joy_take(joy, &m, held_program(), now_ns);
    input->is_pressed = false;
    joy_give(joy, held_program(), input, now_ns);
}

static void test_joy(void)
{
    struct joy joy;
    struct ros_joy small;
    struct held input = { false, false, 0.25 };
    char name[40], why[ROS_REASON];
    memset(&joy, 0, sizeof joy);
    check(settings_of("late=1") == 3 && !joy_is_used(), "other settings remain");
    check(settings_of("joy.drive slowly=0") == 1 && joy_is_used(), "a button operates a hold");
    check(settings_of("joy.pace=1") == 1 && settings_of("joy.2nd go!=0") == 1,
          "an axis a knob, and a button a button");
    joystick(&joy, 0.0f, true, &input, 0);
    check(input.is_held && !input.is_pressed,
          "a button that is down at first is held, but was not pressed now");
    check_near(input.pace, 0.25, 0, "an axis at rest is the initial value of the knob");
    joystick(&joy, 1.0f, false, &input, 20 * MS);
    check(!input.is_held, "the button is released");
    check_near(input.pace, 1.0, 0, "the end of the axis is the maximum");
    joystick(&joy, -0.5f, true, &input, 40 * MS);
    check(input.is_held && input.is_pressed, "the button is pressed");
    check_near(input.pace, 0.125, 1e-12, "half of the way to the minimum");
    input.is_pressed = false;
    input.is_held = false;
    joy_give(&joy, held_program(), &input, 400 * MS);
    check(!input.is_pressed, "a press is an event");
    check(!input.is_held, "the page has released the hold, and the joystick has not changed");
    joystick(&joy, -0.5f, false, &input, 420 * MS);
    joystick(&joy, -0.5f, true, &input, 440 * MS);
    joy_give(&joy, held_program(), &input, 1000 * MS);
    check(!input.is_held, "a silent joystick holds nothing");
    check_near(input.pace, 0.25, 0, "and its axes are at rest");

    memset(&small, 0, sizeof small);
    small.button_count = 1;
    small.axis_count = 1;
    check(joy_check(&small, held_program(), why, sizeof why) != NULL, "too few axes are reported");
    small.axis_count = 2;
    small.axes[1] = NAN;
    check(joy_check(&small, held_program(), why, sizeof why) != NULL, "and so is NaN");
    operated_topic(&held_program()->console[2], name, sizeof name);
    check(strcmp(name, "~/buttons/_2nd_go_") == 0, "the topic of a button");
}

/* ---- The time of a simulator */

static void test_sim_clock(void)
{
    struct sim_clock c;
    memset(&c, 0, sizeof c);
    check(sim_clock_take(&c, 100 * S) == 0 && sim_clock_now_ns(&c) == 100 * S, "the first time");
    check(sim_clock_take(&c, 101 * S) == 0 && sim_clock_now_ns(&c) == 101 * S, "the next one");
    check(sim_clock_take(&c, 5 * S) == -96 * S && sim_clock_now_ns(&c) == 101 * S,
          "after a restart of the simulator, the program's time does not go back");
    check(sim_clock_take(&c, 6 * S) == 0 && sim_clock_now_ns(&c) == 102 * S, "it continues");
    check(sim_clock_take(&c, 60 * S) == 54 * S && sim_clock_now_ns(&c) == 102 * S,
          "it does not jump far ahead");
}

/* ---- The driver, with the core that stops the robot */

struct bench {
    struct frob_fake_clock time;
    struct frob_fake_line line;
    struct ros_device device;
    double settings[ROS_SETTINGS];
    struct frob_robot robot;
    double v, turn; /* the velocity that was received last */
    int received;
};

static void start(struct bench *b)
{
    struct frob_serial serial;
    struct frob_clock clock;
    memset(b, 0, sizeof *b);
    for (size_t i = 0; i < ROS_SETTINGS; i++)
        b->settings[i] = frob_ros_driver.settings[i].initial;
    b->time.now_ns = 5 * S;
    frob_fake_line_open(&b->line, &b->time);
    serial = frob_fake_serial(&b->line);
    clock = frob_fake_time(&b->time);
    frob_robot_start(&b->robot, &frob_ros_driver, &b->device, b->settings, &serial, &clock,
                     PATIENCE);
}

static void receive(struct bench *b)
{
    struct ros_velocity velocity;
    while (frob_fake_receive(&b->line, (uint8_t *)&velocity, sizeof velocity) == sizeof velocity) {
        b->v = velocity.speed_m_s;
        b->turn = velocity.turn_rad_s;
        b->received++;
    }
}

/* For some time, sends odometry every 20 ms if `sends`, and a command after each poll if
 * `drives`. */
static void run(struct bench *b, double seconds, bool sends, bool drives)
{
    const int64_t end_ns = b->time.now_ns + (int64_t)(seconds * 1e9);
    for (; b->time.now_ns < end_ns; b->time.now_ns += 20 * MS) {
        struct ros_odometry o = facing(0.5);
        struct frob_ros_input input;
        struct frob_ros_output output = { 0.4, -5.0 };
        o.arrived_ns = o.stamp_ns = b->time.now_ns;
        o.speed_m_s = 0.4;
        if (sends)
            frob_fake_send(&b->line, (const uint8_t *)&o, sizeof o, 0);
        if (frob_robot_poll(&b->robot) == FROB_ROBOT_READY && drives) {
            frob_robot_sense(&b->robot, &input);
            frob_robot_command(&b->robot, &output);
        }
        receive(b);
    }
}

static void test_driver(void)
{
    static struct bench b;
    struct frob_ros_input input;
    struct ros_odometry late = facing(0);
    start(&b);
    run(&b, 0.5, false, true);
    check(b.robot.state == FROB_ROBOT_CONNECTING && b.received == 0,
          "without odometry, the robot is not connected, and nothing is published");
    run(&b, 0.5, true, true);
    check(b.robot.state == FROB_ROBOT_READY, "it is connected by the first message");
    frob_robot_sense(&b.robot, &input);
    check_near(input.odometry.heading, 0.5, 1e-12, "the program reads the message");
    check_near(input.speed, 0.4, 0, "and its speed");
    check_near(b.v, 0.4, 0, "the program's speed is published");
    check_near(b.turn, -3.0, 0, "turn rates are limited by a setting");
    b.received = 0;
    run(&b, 0.2, true, false);
    check(b.received >= 1 && b.v == 0.4, "a velocity is repeated until there is another");
    run(&b, 0.4, false, true);
    check(b.robot.state == FROB_ROBOT_STALE, "without messages, readings are stale");
    check(b.v == 0.0 && b.turn == 0.0, "then the robot is stopped");
    run(&b, 0.1, true, true);
    check(b.robot.state == FROB_ROBOT_READY && b.v == 0.4, "it continues with the next message");
    for (int i = 0; i < 30; i++) {
        late.arrived_ns = b.time.now_ns;
        late.stamp_ns = b.time.now_ns - 500 * MS;
        frob_fake_send(&b.line, (const uint8_t *)&late, sizeof late, 0);
        run(&b, 0.02, false, true);
    }
    check(b.robot.state == FROB_ROBOT_STALE && b.v == 0.0, "late messages do not move the robot");

    start(&b);
    run(&b, 0.1, true, true);
    for (size_t i = 0; i < sizeof late; i++) {
        late = facing(0.7);
        late.arrived_ns = late.stamp_ns = b.time.now_ns;
        frob_fake_send(&b.line, (const uint8_t *)&late + i, 1, 0);
        frob_robot_poll(&b.robot);
    }
    frob_robot_sense(&b.robot, &input);
    check_near(input.odometry.heading, 0.7, 1e-12, "a message may arrive in pieces");
    {
        const struct ros_head wrong = { 1u << 30, ROS_ODOMETRY };
        frob_fake_send(&b.line, (const uint8_t *)&wrong, sizeof wrong, 0);
        check(frob_robot_poll(&b.robot) == FROB_ROBOT_FAILED, "a wrong size ends the session");
    }
}

static void send_clock(struct bench *b, int64_t time_ns)
{
    const struct ros_clock clock = { { sizeof clock, ROS_CLOCK }, time_ns };
    frob_fake_send(&b->line, (const uint8_t *)&clock, sizeof clock, 0);
}

/* A simulator at a tenth of real time, whose messages have stamps in its time. */
static void test_driver_in_simulation(void)
{
    static struct bench b;
    const int64_t first_ns = 5 * S;
    start(&b);
    b.settings[ROS_SIM_TIME] = 1.0;
    check(ros_device_time_ns(&b.device, b.time.now_ns) == INT64_MIN, "no time before /clock");
    run(&b, 0.1, true, true);
    check(b.robot.state == FROB_ROBOT_CONNECTING, "nor do messages count");
    for (int i = 0; i < 200; i++) {
        struct ros_odometry o = facing(0.5);
        send_clock(&b, 1000 * S + (b.time.now_ns - first_ns) / 10);
        o.stamp_ns = 1000 * S + (b.time.now_ns - first_ns) / 10;
        o.arrived_ns = b.time.now_ns;
        frob_fake_send(&b.line, (const uint8_t *)&o, sizeof o, 0);
        run(&b, 0.02, false, true);
        check_failures += i > 1 && b.robot.state != FROB_ROBOT_READY ? 1 : 0;
    }
    check(check_failures == 0, "messages of a slow simulator count");
    check(ros_device_time_ns(&b.device, b.time.now_ns) < 1001 * S, "time is that of /clock");
    run(&b, 1.0, false, true);
    check(b.robot.state == FROB_ROBOT_STALE && b.v == 0.0,
          "a simulator that stops stops the robot");
}

int main(void)
{
    test_stamps();
    test_odometry();
    test_scan();
    test_frames();
    test_seat();
    test_imu();
    test_imu_frame();
    test_parameters();
    test_joy();
    test_sim_clock();
    test_driver();
    test_driver_in_simulation();
    return check_status();
}
