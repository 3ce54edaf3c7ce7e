/* fake_ros.h -- the part of rcl and of the message packages that the host uses, without ROS.
 *
 * There is one robot, in fake_ros.c, which publishes its odometry and drives at the commanded
 * velocity. Types have only the members that the host uses. build.sh installs this header under the
 * names that the host includes. */
#ifndef FAKE_ROS_H
#define FAKE_ROS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- rcl */

typedef struct rosidl_message_type_support_t rosidl_message_type_support_t;
struct rosidl_message_type_support_t {
    const char *name;
    const void *data; /* its introspection; NULL for types that no test uses in this way */
    const rosidl_message_type_support_t *(*func)(const rosidl_message_type_support_t *support,
                                                 const char *identifier);
};

/* ---- Introspection */

enum {
    rosidl_typesupport_introspection_c__ROS_TYPE_FLOAT = 1,
    rosidl_typesupport_introspection_c__ROS_TYPE_DOUBLE,
    rosidl_typesupport_introspection_c__ROS_TYPE_LONG_DOUBLE,
    rosidl_typesupport_introspection_c__ROS_TYPE_CHAR,
    rosidl_typesupport_introspection_c__ROS_TYPE_WCHAR,
    rosidl_typesupport_introspection_c__ROS_TYPE_BOOLEAN,
    rosidl_typesupport_introspection_c__ROS_TYPE_OCTET,
    rosidl_typesupport_introspection_c__ROS_TYPE_UINT8,
    rosidl_typesupport_introspection_c__ROS_TYPE_INT8,
    rosidl_typesupport_introspection_c__ROS_TYPE_UINT16,
    rosidl_typesupport_introspection_c__ROS_TYPE_INT16,
    rosidl_typesupport_introspection_c__ROS_TYPE_UINT32,
    rosidl_typesupport_introspection_c__ROS_TYPE_INT32,
    rosidl_typesupport_introspection_c__ROS_TYPE_UINT64,
    rosidl_typesupport_introspection_c__ROS_TYPE_INT64,
    rosidl_typesupport_introspection_c__ROS_TYPE_STRING,
    rosidl_typesupport_introspection_c__ROS_TYPE_WSTRING,
    rosidl_typesupport_introspection_c__ROS_TYPE_MESSAGE
};
enum rosidl_runtime_c__message_initialization { ROSIDL_RUNTIME_C_MSG_INIT_ALL };

typedef struct {
    const char *name_;
    uint8_t type_id_;
    const rosidl_message_type_support_t *members_;
    bool is_array_;
    size_t array_size_;
    bool is_upper_bound_;
    uint32_t offset_;
    size_t (*size_function)(const void *array);
    const void *(*get_const_function)(const void *array, size_t index);
    void *(*get_function)(void *array, size_t index);
    bool (*resize_function)(void *array, size_t size);
} rosidl_typesupport_introspection_c__MessageMember;

typedef struct {
    const char *message_namespace_;
    const char *message_name_;
    uint32_t member_count_;
    size_t size_of_;
    const rosidl_typesupport_introspection_c__MessageMember *members_;
    void (*init_function)(void *message, enum rosidl_runtime_c__message_initialization how);
} rosidl_typesupport_introspection_c__MessageMembers;

typedef int rcl_ret_t;
#define RCL_RET_OK 0
#define RCL_RET_ERROR 1
#define RCL_RET_TIMEOUT 2
#define RCL_RET_INVALID_ROS_ARGS 1003
#define RCUTILS_RET_OK 0

typedef struct {
    int unused;
} rcutils_allocator_t;
typedef rcutils_allocator_t rcl_allocator_t;
typedef struct {
    char str[256];
} rcl_error_string_t;
typedef struct {
    int unused;
} rcl_init_options_t;
typedef struct {
    int unused;
} rcl_context_t;
typedef struct {
    int unused;
} rcl_node_options_t;
typedef struct {
    char name[128];
} rcl_node_t;
typedef struct {
    char topic[128];
    const rosidl_message_type_support_t *type;
} rcl_subscription_t;
typedef struct {
    char topic[128];
} rcl_publisher_t;
typedef struct {
    int ends[2];
} rcl_guard_condition_t;
typedef struct {
    int unused;
} rcl_guard_condition_options_t;
enum { RMW_QOS_POLICY_DURABILITY_VOLATILE, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL };
enum {
    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
    RMW_QOS_POLICY_RELIABILITY_RELIABLE,
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT
};
typedef struct {
    size_t depth;
    int durability, reliability;
} rmw_qos_profile_t;
typedef struct {
    rmw_qos_profile_t qos;
} rcl_subscription_options_t;
typedef struct {
    rmw_qos_profile_t qos;
} rcl_publisher_options_t;

typedef struct {
    char name[128];
} rcl_service_t;
typedef struct {
    rmw_qos_profile_t qos;
} rcl_service_options_t;
typedef struct {
    int number;
} rmw_request_id_t;
typedef struct {
    const char *name;
} rosidl_service_type_support_t;

typedef struct {
    size_t count, service_count;
    const rcl_subscription_t *subscriptions[32];
    const rcl_service_t *services[11];
    const rcl_guard_condition_t *guard_conditions[1];
} rcl_wait_set_t;

typedef struct {
    const char *node_name;
    const char *topic_type;
    rmw_qos_profile_t qos_profile;
} rcl_topic_endpoint_info_t;

typedef struct {
    size_t size;
    rcl_topic_endpoint_info_t *info_array;
} rcl_topic_endpoint_info_array_t;

typedef struct {
    size_t size;
    char **data;
} rcutils_string_array_t;

static const rmw_qos_profile_t rmw_qos_profile_sensor_data = {
    5, 0, RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT
};
static const rmw_qos_profile_t rmw_qos_profile_parameters = { 1000, 0, 0 };
static const rmw_qos_profile_t rmw_qos_profile_parameter_events = { 1000, 0, 0 };

rcl_allocator_t rcl_get_default_allocator(void);
rcutils_allocator_t rcutils_get_default_allocator(void);
rcl_error_string_t rcl_get_error_string(void);
void rcl_reset_error(void);
void rcutils_reset_error(void);

rcl_init_options_t rcl_get_zero_initialized_init_options(void);
rcl_ret_t rcl_init_options_init(rcl_init_options_t *options, rcl_allocator_t allocator);
rcl_ret_t rcl_init_options_fini(rcl_init_options_t *options);
rcl_context_t rcl_get_zero_initialized_context(void);
rcl_ret_t rcl_init(int argc, char const *const *argv, const rcl_init_options_t *options,
                   rcl_context_t *context);
rcl_ret_t rcl_shutdown(rcl_context_t *context);
rcl_ret_t rcl_context_fini(rcl_context_t *context);

rcl_node_options_t rcl_node_get_default_options(void);
rcl_node_t rcl_get_zero_initialized_node(void);
rcl_ret_t rcl_node_init(rcl_node_t *node, const char *name, const char *space,
                        rcl_context_t *context, const rcl_node_options_t *options);
rcl_ret_t rcl_node_fini(rcl_node_t *node);
const char *rcl_node_get_name(const rcl_node_t *node);
const char *rcl_node_get_namespace(const rcl_node_t *node);
const char *rcl_node_get_fully_qualified_name(const rcl_node_t *node);

rcl_subscription_t rcl_get_zero_initialized_subscription(void);
rcl_subscription_options_t rcl_subscription_get_default_options(void);
rcl_ret_t rcl_subscription_init(rcl_subscription_t *subscription, const rcl_node_t *node,
                                const rosidl_message_type_support_t *type, const char *topic,
                                const rcl_subscription_options_t *options);
rcl_ret_t rcl_subscription_fini(rcl_subscription_t *subscription, rcl_node_t *node);
const char *rcl_subscription_get_topic_name(const rcl_subscription_t *subscription);
rcl_ret_t rcl_take(const rcl_subscription_t *subscription, void *message, void *information,
                   void *allocation);

rcl_publisher_t rcl_get_zero_initialized_publisher(void);
rcl_publisher_options_t rcl_publisher_get_default_options(void);
rcl_ret_t rcl_publisher_init(rcl_publisher_t *publisher, const rcl_node_t *node,
                             const rosidl_message_type_support_t *type, const char *topic,
                             const rcl_publisher_options_t *options);
rcl_ret_t rcl_publisher_fini(rcl_publisher_t *publisher, rcl_node_t *node);
const char *rcl_publisher_get_topic_name(const rcl_publisher_t *publisher);
rcl_ret_t rcl_publish(const rcl_publisher_t *publisher, const void *message, void *allocation);
rcl_ret_t rcl_publisher_get_subscription_count(const rcl_publisher_t *publisher, size_t *count);
rcl_ret_t rcl_publisher_wait_for_all_acked(const rcl_publisher_t *publisher, int64_t timeout_ns);

rcl_service_t rcl_get_zero_initialized_service(void);
rcl_service_options_t rcl_service_get_default_options(void);
rcl_ret_t rcl_service_init(rcl_service_t *service, const rcl_node_t *node,
                           const rosidl_service_type_support_t *type, const char *name,
                           const rcl_service_options_t *options);
rcl_ret_t rcl_service_fini(rcl_service_t *service, rcl_node_t *node);
rcl_ret_t rcl_take_request(const rcl_service_t *service, rmw_request_id_t *id, void *request);
rcl_ret_t rcl_send_response(const rcl_service_t *service, rmw_request_id_t *id, void *response);

rcl_guard_condition_t rcl_get_zero_initialized_guard_condition(void);
rcl_guard_condition_options_t rcl_guard_condition_get_default_options(void);
rcl_ret_t rcl_guard_condition_init(rcl_guard_condition_t *condition, rcl_context_t *context,
                                   rcl_guard_condition_options_t options);
rcl_ret_t rcl_guard_condition_fini(rcl_guard_condition_t *condition);
rcl_ret_t rcl_trigger_guard_condition(rcl_guard_condition_t *condition);

rcl_wait_set_t rcl_get_zero_initialized_wait_set(void);
rcl_ret_t rcl_wait_set_init(rcl_wait_set_t *set, size_t subscriptions, size_t guards, size_t timers,
                            size_t clients, size_t services, size_t events, rcl_context_t *context,
                            rcl_allocator_t allocator);
rcl_ret_t rcl_wait_set_fini(rcl_wait_set_t *set);
rcl_ret_t rcl_wait_set_clear(rcl_wait_set_t *set);
rcl_ret_t rcl_wait_set_add_subscription(rcl_wait_set_t *set, const rcl_subscription_t *subscription,
                                        size_t *index);
rcl_ret_t rcl_wait_set_add_guard_condition(rcl_wait_set_t *set,
                                           const rcl_guard_condition_t *condition, size_t *index);
rcl_ret_t rcl_wait_set_add_service(rcl_wait_set_t *set, const rcl_service_t *service,
                                   size_t *index);
rcl_ret_t rcl_wait(rcl_wait_set_t *set, int64_t timeout_ns);

rcl_topic_endpoint_info_array_t rcl_get_zero_initialized_topic_endpoint_info_array(void);
rcl_ret_t rcl_topic_endpoint_info_array_fini(rcl_topic_endpoint_info_array_t *array,
                                             rcutils_allocator_t *allocator);
rcl_ret_t rcl_get_publishers_info_by_topic(const rcl_node_t *node, rcutils_allocator_t *allocator,
                                           const char *topic, bool no_mangle,
                                           rcl_topic_endpoint_info_array_t *array);
rcl_ret_t rcl_get_subscriptions_info_by_topic(const rcl_node_t *node,
                                              rcutils_allocator_t *allocator, const char *topic,
                                              bool no_mangle,
                                              rcl_topic_endpoint_info_array_t *array);
rcutils_string_array_t rcutils_get_zero_initialized_string_array(void);
rcl_ret_t rcutils_string_array_fini(rcutils_string_array_t *array);
rcl_ret_t rcl_get_node_names(const rcl_node_t *node, rcl_allocator_t allocator,
                             rcutils_string_array_t *names, rcutils_string_array_t *spaces);

typedef struct {
    bool *bool_value;
    int64_t *integer_value;
    double *double_value;
    char *string_value;
} rcl_variant_t;
typedef struct {
    char **parameter_names;
    rcl_variant_t *parameter_values;
    size_t num_params;
} rcl_node_params_t;
typedef struct {
    char **node_names;
    rcl_node_params_t *params;
    size_t num_nodes;
} rcl_params_t;
rcl_params_t *rcl_yaml_node_struct_init(rcutils_allocator_t allocator);
bool rcl_parse_yaml_file(const char *file, rcl_params_t *params);
void rcl_yaml_node_struct_fini(rcl_params_t *params);

/* ---- Messages */

typedef struct {
    char *data;
} rosidl_runtime_c__String;
bool rosidl_runtime_c__String__assign(rosidl_runtime_c__String *string, const char *text);

typedef struct {
    rosidl_runtime_c__String data;
} std_msgs__msg__String;
bool std_msgs__msg__String__init(std_msgs__msg__String *message);
extern const rosidl_message_type_support_t fake_std_msgs_String;

typedef struct {
    bool data;
} std_msgs__msg__Bool;
extern const rosidl_message_type_support_t fake_std_msgs_Bool;

typedef struct {
    double x, y, z;
} geometry_msgs__msg__Vector3;
typedef struct {
    double x, y, z;
} geometry_msgs__msg__Point;
typedef struct {
    double x, y, z, w;
} geometry_msgs__msg__Quaternion;
typedef struct {
    geometry_msgs__msg__Vector3 linear, angular;
} geometry_msgs__msg__Twist;
typedef struct {
    geometry_msgs__msg__Point position;
    geometry_msgs__msg__Quaternion orientation;
} geometry_msgs__msg__Pose;
typedef struct {
    int32_t sec;
    uint32_t nanosec;
} builtin_interfaces__msg__Time;
typedef struct {
    builtin_interfaces__msg__Time clock;
} rosgraph_msgs__msg__Clock;
typedef struct {
    builtin_interfaces__msg__Time stamp;
    rosidl_runtime_c__String frame_id;
} std_msgs__msg__Header;
typedef struct {
    std_msgs__msg__Header header;
    geometry_msgs__msg__Twist twist;
} geometry_msgs__msg__TwistStamped;
typedef struct {
    geometry_msgs__msg__Vector3 translation;
    geometry_msgs__msg__Quaternion rotation;
} geometry_msgs__msg__Transform;
typedef struct {
    std_msgs__msg__Header header;
    rosidl_runtime_c__String child_frame_id;
    geometry_msgs__msg__Transform transform;
} geometry_msgs__msg__TransformStamped;
typedef struct {
    std_msgs__msg__Header header;
    geometry_msgs__msg__Point point;
} geometry_msgs__msg__PointStamped;
bool geometry_msgs__msg__PointStamped__init(geometry_msgs__msg__PointStamped *message);
typedef struct {
    geometry_msgs__msg__TransformStamped *data;
    size_t size;
} geometry_msgs__msg__TransformStamped__Sequence;
bool geometry_msgs__msg__TransformStamped__Sequence__init(
    geometry_msgs__msg__TransformStamped__Sequence *sequence, size_t size);
typedef struct {
    std_msgs__msg__Header header;
    rosidl_runtime_c__String child_frame_id;
    struct {
        geometry_msgs__msg__Pose pose;
    } pose;
    struct {
        geometry_msgs__msg__Twist twist;
    } twist;
} nav_msgs__msg__Odometry;

typedef struct {
    float *data;
    size_t size;
} rosidl_runtime_c__float__Sequence;
bool rosidl_runtime_c__float__Sequence__init(rosidl_runtime_c__float__Sequence *sequence,
                                             size_t size);
void rosidl_runtime_c__float__Sequence__fini(rosidl_runtime_c__float__Sequence *sequence);
typedef struct {
    std_msgs__msg__Header header;
    float angle_min, angle_max, angle_increment, time_increment, scan_time, range_min, range_max;
    rosidl_runtime_c__float__Sequence ranges;
} sensor_msgs__msg__LaserScan;
typedef struct {
    std_msgs__msg__Header header;
    geometry_msgs__msg__Quaternion orientation;
    double orientation_covariance[9];
    geometry_msgs__msg__Vector3 angular_velocity, linear_acceleration;
} sensor_msgs__msg__Imu;

#define SEQUENCE(type)  \
    typedef struct {    \
        type *data;     \
        size_t size;    \
    } type##__Sequence; \
    bool type##__Sequence__init(type##__Sequence *sequence, size_t size)

SEQUENCE(geometry_msgs__msg__Point);
typedef struct {
    float r, g, b, a;
} std_msgs__msg__ColorRGBA;
enum {
    visualization_msgs__msg__Marker__ADD,
    visualization_msgs__msg__Marker__DELETE = 2,
    visualization_msgs__msg__Marker__ARROW = 0,
    visualization_msgs__msg__Marker__LINE_STRIP = 4,
    visualization_msgs__msg__Marker__LINE_LIST = 5,
    visualization_msgs__msg__Marker__TEXT_VIEW_FACING = 9
};
typedef struct {
    std_msgs__msg__Header header;
    rosidl_runtime_c__String ns;
    int32_t id, type, action;
    geometry_msgs__msg__Pose pose;
    geometry_msgs__msg__Vector3 scale;
    std_msgs__msg__ColorRGBA color;
    bool frame_locked;
    geometry_msgs__msg__Point__Sequence points;
    rosidl_runtime_c__String text;
} visualization_msgs__msg__Marker;
SEQUENCE(visualization_msgs__msg__Marker);
typedef struct {
    visualization_msgs__msg__Marker__Sequence markers;
} visualization_msgs__msg__MarkerArray;
bool visualization_msgs__msg__MarkerArray__init(visualization_msgs__msg__MarkerArray *message);

typedef struct {
    uint8_t structure_needs_at_least_one_member;
} std_msgs__msg__Empty;
bool std_msgs__msg__Empty__init(std_msgs__msg__Empty *message);
typedef int32_t rosidl_runtime_c__int32;
SEQUENCE(rosidl_runtime_c__int32);
typedef struct {
    std_msgs__msg__Header header;
    rosidl_runtime_c__float__Sequence axes;
    rosidl_runtime_c__int32__Sequence buttons;
} sensor_msgs__msg__Joy;
bool sensor_msgs__msg__Joy__init(sensor_msgs__msg__Joy *message);

typedef uint8_t rosidl_runtime_c__uint8;
SEQUENCE(rosidl_runtime_c__uint8);
void rosidl_runtime_c__uint8__Sequence__fini(rosidl_runtime_c__uint8__Sequence *sequence);

typedef struct {
    std_msgs__msg__Header header;
    uint32_t height, width, step;
    rosidl_runtime_c__String encoding;
    rosidl_runtime_c__uint8__Sequence data;
} sensor_msgs__msg__Image;
bool sensor_msgs__msg__Image__init(sensor_msgs__msg__Image *message);
typedef struct {
    std_msgs__msg__Header header;
    rosidl_runtime_c__String format;
    rosidl_runtime_c__uint8__Sequence data;
} sensor_msgs__msg__CompressedImage;
bool sensor_msgs__msg__CompressedImage__init(sensor_msgs__msg__CompressedImage *message);

bool std_msgs__msg__Bool__init(std_msgs__msg__Bool *message);
typedef struct {
    std_msgs__msg__Header header;
    float voltage, temperature, current, charge, capacity, design_capacity, percentage;
    bool present;
} sensor_msgs__msg__BatteryState;
bool sensor_msgs__msg__BatteryState__init(sensor_msgs__msg__BatteryState *message);

/* ---- Parameters */

SEQUENCE(rosidl_runtime_c__String);

typedef struct {
    uint8_t type;
    bool bool_value;
    int64_t integer_value;
    double double_value;
} rcl_interfaces__msg__ParameterValue;
SEQUENCE(rcl_interfaces__msg__ParameterValue);
typedef struct {
    rosidl_runtime_c__String name;
    rcl_interfaces__msg__ParameterValue value;
} rcl_interfaces__msg__Parameter;
SEQUENCE(rcl_interfaces__msg__Parameter);
typedef struct {
    bool successful;
    rosidl_runtime_c__String reason;
} rcl_interfaces__msg__SetParametersResult;
SEQUENCE(rcl_interfaces__msg__SetParametersResult);
typedef struct {
    double from_value, to_value;
} rcl_interfaces__msg__FloatingPointRange;
SEQUENCE(rcl_interfaces__msg__FloatingPointRange);
typedef struct {
    int64_t from_value, to_value;
} rcl_interfaces__msg__IntegerRange;
SEQUENCE(rcl_interfaces__msg__IntegerRange);
typedef struct {
    rosidl_runtime_c__String name, description;
    uint8_t type;
    bool read_only;
    rcl_interfaces__msg__FloatingPointRange__Sequence floating_point_range;
    rcl_interfaces__msg__IntegerRange__Sequence integer_range;
} rcl_interfaces__msg__ParameterDescriptor;
SEQUENCE(rcl_interfaces__msg__ParameterDescriptor);
typedef struct {
    rosidl_runtime_c__String__Sequence names;
} rcl_interfaces__msg__ListParametersResult;
typedef struct {
    builtin_interfaces__msg__Time stamp;
    rosidl_runtime_c__String node;
    rcl_interfaces__msg__Parameter__Sequence changed_parameters;
} rcl_interfaces__msg__ParameterEvent;
bool rcl_interfaces__msg__ParameterEvent__init(rcl_interfaces__msg__ParameterEvent *event);
void rcl_interfaces__msg__ParameterEvent__fini(rcl_interfaces__msg__ParameterEvent *event);

typedef struct {
    uint8_t level;
    rosidl_runtime_c__String name, message, hardware_id;
} diagnostic_msgs__msg__DiagnosticStatus;
SEQUENCE(diagnostic_msgs__msg__DiagnosticStatus);
typedef struct {
    std_msgs__msg__Header header;
    diagnostic_msgs__msg__DiagnosticStatus__Sequence status;
} diagnostic_msgs__msg__DiagnosticArray;
bool diagnostic_msgs__msg__DiagnosticArray__init(diagnostic_msgs__msg__DiagnosticArray *message);
extern const rosidl_message_type_support_t fake_diagnostic_msgs_DiagnosticArray;

#define SERVICE(Name, request, response)                              \
    typedef struct {                                                  \
        request;                                                      \
    } rcl_interfaces__srv__##Name##_Request;                          \
    typedef struct {                                                  \
        response;                                                     \
    } rcl_interfaces__srv__##Name##_Response;                         \
    bool rcl_interfaces__srv__##Name##_Request__init(void *message);  \
    bool rcl_interfaces__srv__##Name##_Response__init(void *message); \
    void rcl_interfaces__srv__##Name##_Request__fini(void *message);  \
    void rcl_interfaces__srv__##Name##_Response__fini(void *message); \
    extern const rosidl_service_type_support_t fake_rcl_interfaces_srv_##Name

SERVICE(SetParameters, rcl_interfaces__msg__Parameter__Sequence parameters,
        rcl_interfaces__msg__SetParametersResult__Sequence results);
SERVICE(SetParametersAtomically, rcl_interfaces__msg__Parameter__Sequence parameters,
        rcl_interfaces__msg__SetParametersResult result);
SERVICE(GetParameters, rosidl_runtime_c__String__Sequence names,
        rcl_interfaces__msg__ParameterValue__Sequence values);
SERVICE(GetParameterTypes, rosidl_runtime_c__String__Sequence names,
        rosidl_runtime_c__uint8__Sequence types);
SERVICE(DescribeParameters, rosidl_runtime_c__String__Sequence names,
        rcl_interfaces__msg__ParameterDescriptor__Sequence descriptors);
SERVICE(ListParameters, rosidl_runtime_c__String__Sequence prefixes;
        uint64_t depth, rcl_interfaces__msg__ListParametersResult result);
#undef SERVICE
#define ROSIDL_GET_SRV_TYPE_SUPPORT(package, kind, name) (&fake_##package##_srv_##name)

bool rosgraph_msgs__msg__Clock__init(rosgraph_msgs__msg__Clock *message);
bool sensor_msgs__msg__LaserScan__init(sensor_msgs__msg__LaserScan *message);
bool sensor_msgs__msg__Imu__init(sensor_msgs__msg__Imu *message);
bool geometry_msgs__msg__Twist__init(geometry_msgs__msg__Twist *message);
bool geometry_msgs__msg__TwistStamped__init(geometry_msgs__msg__TwistStamped *message);
bool nav_msgs__msg__Odometry__init(nav_msgs__msg__Odometry *message);

extern const rosidl_message_type_support_t fake_geometry_msgs_Twist;
extern const rosidl_message_type_support_t fake_geometry_msgs_PointStamped;
extern const rosidl_message_type_support_t fake_sensor_msgs_Joy;
extern const rosidl_message_type_support_t fake_visualization_msgs_MarkerArray;
extern const rosidl_message_type_support_t fake_std_msgs_Empty;
extern const rosidl_message_type_support_t fake_geometry_msgs_TwistStamped;
extern const rosidl_message_type_support_t fake_nav_msgs_Odometry;
extern const rosidl_message_type_support_t fake_tf2_msgs_TFMessage;
extern const rosidl_message_type_support_t fake_sensor_msgs_LaserScan;
extern const rosidl_message_type_support_t fake_sensor_msgs_Imu;
extern const rosidl_message_type_support_t fake_std_msgs_Bool;
extern const rosidl_message_type_support_t fake_sensor_msgs_Image;
extern const rosidl_message_type_support_t fake_sensor_msgs_CompressedImage;
extern const rosidl_message_type_support_t fake_sensor_msgs_BatteryState;
extern const rosidl_message_type_support_t fake_rosgraph_msgs_Clock;
extern const rosidl_message_type_support_t fake_rcl_interfaces_ParameterEvent;
#define ROSIDL_GET_MSG_TYPE_SUPPORT(package, kind, name) (&fake_##package##_##name)

/* Defines the type support of a service and the functions for its messages. */
#define FAKE_SERVICE(package, Name)                             \
    bool package##__srv__##Name##_Request__init(void *message)  \
    {                                                           \
        return message != NULL;                                 \
    }                                                           \
    bool package##__srv__##Name##_Response__init(void *message) \
    {                                                           \
        return message != NULL;                                 \
    }                                                           \
    void package##__srv__##Name##_Request__fini(void *message)  \
    {                                                           \
        (void)message;                                          \
    }                                                           \
    void package##__srv__##Name##_Response__fini(void *message) \
    {                                                           \
        (void)message;                                          \
    }                                                           \
    const rosidl_service_type_support_t fake_##package##_srv_##Name = { #Name };

#include "fake_lifecycle.h"

#endif
