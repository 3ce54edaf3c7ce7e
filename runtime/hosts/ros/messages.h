/* messages.h -- the messages between the supervisor and the node, which is a separate process
 * (node.h). Both processes run the same executable, so a message can be a plain struct.
 *
 * Each message begins with its size and kind. The socket between the processes transfers each
 * message either completely or not at all. */
#ifndef FROB_HOST_ROS_MESSAGES_H
#define FROB_HOST_ROS_MESSAGES_H

#include <stdbool.h>
#include <stdint.h>

enum ros_kind {
    /* From the node. */
    ROS_STARTED = 1, /* the node has joined the ROS 2 system; the rest is a struct ros_started */
    ROS_REFUSED,     /* the node could not join; the rest is a struct ros_refused */
    ROS_ODOMETRY,
    ROS_SCAN,
    ROS_IMU,
    ROS_CLOCK, /* the simulator's time; the rest is a struct ros_clock */
    ROS_BUMPER,
    ROS_BATTERY,
    ROS_STATES, /* the simulated robot's bumpers and battery; the rest is a struct ros_states */
    ROS_IMAGE,  /* the simulated robot's camera has taken an image; a struct ros_image */
    ROS_STATE,  /* a managed node has changed its state; the rest is a struct ros_state */
    ROS_JOY,
    ROS_PRESS, /* a button on the console was pressed; a struct ros_press */
    ROS_CLICK, /* a click on a map; a struct ros_click */
    ROS_TF,    /* used only inside the node: transforms from /tf, or from /tf_static */
    ROS_TF_STATIC,
    ROS_NAMED, /* the name of one of the program's own topics; the rest is a struct ros_named */
    ROS_TOPIC, /* a message on such a topic: a struct ros_topic_message, followed by the value */
    /* To the node. */
    ROS_VELOCITY,
    /* An instant of the run, or the run's columns, as text: a struct ros_text, followed by the
     * text. */
    ROS_TEXT,
    ROS_OUTPUT, /* publish the program's own topics: a struct ros_output, followed by the
                 * output */
    ROS_REST,   /* publish zeros on the program's own topics that are commands */
    ROS_MARKS,  /* publish the program's drawing: a struct ros_marks, followed by its bytes */
    ROS_CLAIM,  /* the verdict on an assertion; the rest is a struct ros_claim */
    /* Sent in both directions when a control on the console has a new value; a struct
     * ros_touch. */
    ROS_TOUCH
};

struct ros_head {
    uint32_t size; /* size of the whole message */
    uint32_t kind;
};

enum { ROS_NAME = 256, ROS_REASON = 1400 };

/* Maximum number of lidars and inertial measurement units that a program can use. */
enum { ROS_SENSORS_MOST = 8 };

struct ros_started {
    struct ros_head head;
    char node[ROS_NAME];     /* with its namespace: "/wall_follow" */
    char odometry[ROS_NAME]; /* the names of the topics, after remapping */
    char velocity[ROS_NAME];
    char joy[ROS_NAME];   /* "" if the program does not read a joystick */
    char click[ROS_NAME]; /* "" if the program has no map */
    uint32_t sensor_count;
    struct {
        uint32_t control; /* see struct ros_origin */
        char topic[ROS_NAME];
    } sensors[ROS_SENSORS_MOST];
};

struct ros_refused {
    struct ros_head head;
    char reason[ROS_REASON];
};

/* The numbers of a nav_msgs/msg/Odometry, unchecked. */
struct ros_odometry {
    struct ros_head head;
    int64_t stamp_ns;   /* time in the header, on the sender's clock */
    int64_t arrived_ns; /* time at which the node received it, on this machine's monotonic
                         * clock */
    double x_m, y_m;
    double rotation[4]; /* quaternion: x, y, z, w */
    double speed_m_s, turning_rad_s;
};

/* The sensor that a message comes from, and the message's timestamps. */
struct ros_origin {
    uint32_t control; /* index of the first control on the program's console that uses the sensor */
    int64_t stamp_ns; /* see struct ros_odometry */
    int64_t arrived_ns;
};

enum { ROS_FRAME = 128 };

/* Whether the transform from a message's frame to another frame is known. */
enum ros_fate {
    ROS_FOUND,
    ROS_NOT_FOUND, /* no transform is known */
    ROS_NOT_READ   /* the node cannot read transforms: the package tf2_msgs is missing */
};

struct ros_placing {
    uint32_t fate;         /* enum ros_fate */
    char frame[ROS_FRAME]; /* the message's frame */
    char in[ROS_FRAME];    /* the robot's frame, or the odometry frame */
};

/* The mounting pose of a lidar on the robot. */
struct ros_seat {
    double x_m, y_m, heading_rad; /* positive to the left */
    bool is_upside_down;          /* whether the lidar's positive angles are to the right */
};

enum { ROS_RAYS_MOST = 8192 };

/* A sensor_msgs/msg/LaserScan, unchecked. The message ends after `count` ranges. */
struct ros_scan {
    struct ros_head head;
    struct ros_origin origin;
    struct ros_placing placing; /* in the robot's frame */
    struct ros_seat seat;       /* valid if ROS_FOUND */
    bool is_tilted;             /* the same */
    double first_rad, step_rad, nearest_m, farthest_m;
    uint32_t count;
    float ranges_m[ROS_RAYS_MOST];
};

/* A sensor_msgs/msg/Imu, unchecked. */
struct ros_imu {
    struct ros_head head;
    struct ros_origin origin;
    struct ros_placing placing; /* in the robot's frame */
    double mounting[4]; /* the unit's orientation on the robot, a quaternion; valid if ROS_FOUND */
    double rate_radps[3], acceleration_mps2[3];
    double rotation[4]; /* quaternion: x, y, z, w */
    bool has_rotation;
};

/* A std_msgs/msg/Bool. It has no timestamp. */
struct ros_bumper {
    struct ros_head head;
    struct ros_origin origin;
    bool is_pressed;
};

/* A geometry_msgs/msg/PointStamped, unchecked. */
struct ros_click {
    struct ros_head head;
    struct ros_origin origin;
    struct ros_placing placing; /* in the odometry frame */
    double x_m, y_m;            /* in that frame; valid if ROS_FOUND */
};

/* Maximum number of controls that other nodes can operate. */
enum { ROS_CONTROLS_MOST = 64 };

enum { ROS_JOY_MOST = 64 };

/* A sensor_msgs/msg/Joy, unchecked. It contains only the first 64 axes and buttons. */
struct ros_joy {
    struct ros_head head;
    struct ros_origin origin;
    uint32_t axis_count, button_count;
    float axes[ROS_JOY_MOST];
    bool is_down[ROS_JOY_MOST];
};

/* A std_msgs/msg/Empty. */
struct ros_press {
    struct ros_head head;
    uint32_t control; /* index in the program's console */
};

/* The voltage of a sensor_msgs/msg/BatteryState. */
struct ros_battery {
    struct ros_head head;
    double voltage_v;
};

enum { ROS_BUMPERS = 3 };

/* Sent by the simulator. */
struct ros_states {
    struct ros_head head;
    int64_t stamp_ns;
    bool pressed[ROS_BUMPERS]; /* left, right, back */
    double battery_v;
};

enum { ROS_CAMERAS_MOST = 4, ROS_IMAGE_SLOTS = 4, ROS_IMAGE_MOST = 3 * 1920 * 1080 };

/* Sent by the simulator. The pixels are in this camera's slot in shared memory, row by row
 * without gaps. */
struct ros_image {
    struct ros_head head;
    uint32_t camera, slot;
    int64_t stamp_ns;
    uint32_t width, height, channels; /* 1: grey, 3: red, green and blue */
};

/* A rosgraph_msgs/msg/Clock. */
struct ros_clock {
    struct ros_head head;
    int64_t time_ns;
};

/* The state of a managed node. */
struct ros_state {
    struct ros_head head;
    bool is_active; /* the program steps */
    bool is_final;  /* the run ends */
    bool resets;    /* the program restarts in its initial state */
};

/* The program's own topics, identified by their index in its table. */

/* Sent after a struct ros_started, for each topic. */
struct ros_named {
    struct ros_head head;
    uint32_t topic;
    bool is_output;
    char name[ROS_NAME]; /* after remapping */
};

/* A message on a topic. Its value follows this struct: the bytes of the topic's span (topics.h) in
 * the program's input. */
struct ros_topic_message {
    struct ros_head head;
    uint32_t topic;
    uint32_t number;  /* number of the message on this topic, from 1 */
    int64_t stamp_ns; /* 0: the message has no header; otherwise see struct ros_odometry */
    int64_t arrived_ns;
};

struct ros_output {
    struct ros_head head;
    bool rests; /* publish zeros as commands */
};

/* The program's drawing, which follows this struct: the bytes of its span (topics.h) in the
 * program's output. */
struct ros_marks {
    struct ros_head head;
};

/* Maximum size of a value in these messages. It must be much smaller than the socket's buffer. */
enum { ROS_VALUE_MOST = 60000 };

/* A knob or toggle on the program's console, which is a parameter of the node. */
struct ros_touch {
    struct ros_head head;
    uint32_t control; /* index in the program's console */
    bool is_initial;  /* whether the value comes from the ROS arguments */
    double value;     /* in base units; 0 or 1 for a toggle */
};

/* Maximum length of a published text. A message must be much shorter than the socket's buffer. */
enum { ROS_TEXT_MOST = 60000 };

struct ros_text {
    struct ros_head head;
    int64_t number; /* number of the instant; -1 for the columns */
};

/* Levels of diagnostic_msgs/msg/DiagnosticStatus. */
enum ros_level { ROS_OK, ROS_WARN, ROS_ERROR };

enum { ROS_FATE = 100 };

struct ros_claim {
    struct ros_head head;
    uint32_t claim; /* index in the program's table of assertions */
    uint8_t level;  /* enum ros_level */
    char fate[ROS_FATE];
};

/* A velocity to publish. */
struct ros_velocity {
    struct ros_head head;
    double speed_m_s, turn_rad_s;
};

/* Size of the largest message, in bytes. */
enum { ROS_MESSAGE_MOST = ROS_VALUE_MOST + sizeof(struct ros_topic_message) };

#endif
