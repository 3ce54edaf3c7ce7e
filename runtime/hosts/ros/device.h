/* device.h -- the driver of the robot `ros`, whose line connects it to the node (node.h).
 *
 * Like every driver, it makes no decisions about safety: core/robot.h stops the robot if the newest
 * odometry is too old. The driver ignores messages that are late or have invalid numbers, and
 * reports the first of each kind. */
#ifndef FROB_HOST_ROS_DEVICE_H
#define FROB_HOST_ROS_DEVICE_H

#include "drivers/driver.h"
#include "messages.h"
#include "odometry.h"
#include "operated.h"
#include "sensors.h"
#include "sim_clock.h"
#include "stamps.h"

struct line_orders;

/* The driver's settings, in the order of its table. */
enum ros_setting {
    ROS_LATE,
    ROS_LIDAR_X,
    ROS_LIDAR_Y,
    ROS_LIDAR_HEADING,
    ROS_IMU_ALIGNED,
    ROS_SIM_TIME,
    ROS_INSTANTS,
    ROS_LIFECYCLE,
    ROS_OWN_SETTINGS, /* nodes that declare their own topics have only the settings before this
                       * one */
    ROS_FASTEST = ROS_OWN_SETTINGS,
    ROS_FASTEST_TURN,
    ROS_STAMPED,
    ROS_MARKERS,
    ROS_SETTINGS
};

/* A lidar, inertial measurement unit or bumper. */
struct ros_sensor {
    bool used;
    enum ros_kind kind;
    uint32_t control;
    struct ros_topic topic;
    bool fresh;       /* whether a message has arrived that the program has not read yet */
    int64_t taken_ns; /* time at which the newest message was sent */
    struct frob_scan scan;
    double ranges_m[ROS_RAYS_MOST];
    uint32_t number; /* number of scans so far */
    struct ros_measurements sums;
    bool is_pressed;      /* a bumper */
    int64_t lost_ns;      /* time at which its pose on the robot became unknown; INT64_MAX if it is
                      * known */
    char why[ROS_REASON]; /* the reason why its messages are ignored */
};

/* A control on the console whose value other nodes may set. */
struct ros_dial {
    bool is_known; /* whether the node has received the value */
    bool is_set;   /* whether another node has set it, and the program has not read it yet */
    double value;  /* the newest value */
};

/* The state of a managed node. Other nodes are always active. */
struct ros_managed {
    bool is_active, is_final;
    uint32_t resets; /* number of resets requested so far */
};

struct ros_device {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    union {
        struct ros_head head;
        struct ros_started started;
        struct ros_refused refused;
        struct ros_odometry odometry;
        struct ros_scan scan;
        struct ros_imu imu;
        struct ros_clock clock;
        struct ros_touch touch;
        struct ros_state state;
        struct ros_bumper bumper;
        struct ros_battery battery;
        struct ros_click click;
        struct ros_joy joy;
        struct ros_press press;
        uint8_t bytes[ROS_MESSAGE_MOST];
    } message;   /* the message being received */
    size_t have; /* number of bytes of this message received so far */
    struct ros_started started;
    struct ros_topic odometry;
    struct ros_motion motion;
    double battery_v;  /* NaN if it is not known yet */
    int64_t sensed_ns; /* time at which the newest accepted odometry was sent; INT64_MIN if there
                        * was none */
    struct ros_sensor sensors[ROS_SENSORS_MOST];
    struct operated operated;
    struct sim_clock sim_clock;
    struct ros_managed managed;
    struct ros_dial dials[ROS_CONTROLS_MOST]; /* indexed by the number of the control */
    /* Handles messages of kinds that are unknown to this driver; NULL if none are expected. */
    void (*take_other)(struct ros_device *device, const struct ros_head *message);
    bool gave;      /* whether the program has had an instant in this session or an earlier one */
    bool commanded; /* whether a velocity was commanded; if so, the driver repeats it */
    bool drove;     /* whether a velocity was commanded in any session */
    struct ros_velocity velocity;
    int64_t sent_ns;
};

extern const struct frob_driver frob_ros_driver;

/* Sets the controls on the program's console for this instant. */
void ros_device_give(void *device, const struct frob_program *program, void *input, int64_t now_ns);

/* Returns the time on which the program's instants are based: the time of /clock if use_sim_time is
 * set, otherwise `now_ns`, the time of this machine; INT64_MIN if it is not known yet. */
int64_t ros_device_time_ns(const void *device, int64_t now_ns);

/* Returns the requests of the nodes that manage this one. */
struct line_orders ros_device_orders(const void *device);

#endif
