#include "transforms.h"

#include <dlfcn.h>
#include <string.h>

#include <rcl/error_handling.h>
#include <rosidl_runtime_c/string_functions.h>

/* The C type support library of tf2_msgs, and its function for TFMessage. With the headers, the
 * macro ROSIDL_GET_MSG_TYPE_SUPPORT would call the same function. */
static const char library_name[] = "libtf2_msgs__rosidl_typesupport_c.so";
static const char function_name[] =
    "rosidl_typesupport_c__get_message_type_support_handle__tf2_msgs__msg__TFMessage";

/* Queue depth of /tf, as in the package tf2_ros. */
enum { KEPT = 100 };

typedef const rosidl_message_type_support_t *type_function(void);

/* Returns NULL if tf2_msgs is not installed. */
static const rosidl_message_type_support_t *find_type(void)
{
    void *library = dlopen(library_name, RTLD_NOW);
    void *symbol = library != NULL ? dlsym(library, function_name) : NULL;
    type_function *function;
    if (symbol == NULL)
        return NULL;
    memcpy(&function, &symbol, sizeof function);
    return function();
}

static bool prepare(struct transforms_message *message, size_t count)
{
    return geometry_msgs__msg__TransformStamped__Sequence__init(&message->transforms, count);
}

static bool name(geometry_msgs__msg__TransformStamped *transform, const char *from, const char *to)
{
    transform->transform.rotation.w = 1.0;
    return rosidl_runtime_c__String__assign(&transform->header.frame_id, from) &&
           rosidl_runtime_c__String__assign(&transform->child_frame_id, to);
}

static bool advertise(rcl_publisher_t *publisher, const rcl_node_t *node,
                      const rosidl_message_type_support_t *type, const char *topic, size_t depth,
                      bool is_fixed)
{
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    options.qos.depth = depth;
    if (is_fixed)
        options.qos.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
    *publisher = rcl_get_zero_initialized_publisher();
    return rcl_publisher_init(publisher, node, type, topic, &options) == RCL_RET_OK;
}

static void publish(const rcl_publisher_t *publisher, const struct transforms_message *message)
{
    if (rcl_publish(publisher, message, NULL) != RCL_RET_OK)
        rcl_reset_error();
}

bool transforms_start(struct transforms *t, const rcl_node_t *node, const struct seat *seats,
                      size_t count, builtin_interfaces__msg__Time now)
{
    const rosidl_message_type_support_t *type = find_type();
    t->has_type = type != NULL;
    if (!t->has_type)
        return true;
    if (!prepare(&t->odometry, 1) || !prepare(&t->seats, count) ||
        !name(&t->odometry.transforms.data[0], "odom", "base_link") ||
        !advertise(&t->moving, node, type, "/tf", KEPT, false) ||
        !advertise(&t->fixed, node, type, "/tf_static", 1, true))
        return false;
    for (size_t i = 0; i < count; i++) {
        geometry_msgs__msg__TransformStamped *transform = &t->seats.transforms.data[i];
        if (!name(transform, "base_link", seats[i].frame))
            return false;
        transform->header.stamp = now;
        transform->transform.translation.x = seats[i].x_m;
        transform->transform.translation.y = seats[i].y_m;
    }
    publish(&t->fixed, &t->seats);
    return true;
}

void transforms_publish(struct transforms *t, const nav_msgs__msg__Odometry *odometry)
{
    geometry_msgs__msg__TransformStamped *transform;
    if (!t->has_type)
        return;
    transform = &t->odometry.transforms.data[0];
    transform->header.stamp = odometry->header.stamp;
    transform->transform.translation.x = odometry->pose.pose.position.x;
    transform->transform.translation.y = odometry->pose.pose.position.y;
    transform->transform.rotation = odometry->pose.pose.orientation;
    publish(&t->moving, &t->odometry);
}

bool transforms_end(struct transforms *t, rcl_node_t *node)
{
    bool ok = true;
    if (t->has_type) {
        ok = rcl_publisher_fini(&t->moving, node) == RCL_RET_OK;
        ok = rcl_publisher_fini(&t->fixed, node) == RCL_RET_OK && ok;
    }
    return ok;
}
