#include "services.h"

#include <stdio.h>
#include <string.h>
#include <sys/socket.h>

#include <rcl/error_handling.h>
#include <rcl_interfaces/msg/floating_point_range.h>
#include <rcl_interfaces/msg/integer_range.h>
#include <rcl_interfaces/msg/parameter.h>
#include <rcl_interfaces/msg/parameter_descriptor.h>
#include <rcl_interfaces/msg/parameter_event.h>
#include <rcl_interfaces/msg/parameter_value.h>
#include <rcl_interfaces/msg/set_parameters_result.h>
#include <rcl_interfaces/srv/describe_parameters.h>
#include <rcl_interfaces/srv/get_parameter_types.h>
#include <rcl_interfaces/srv/get_parameters.h>
#include <rcl_interfaces/srv/list_parameters.h>
#include <rcl_interfaces/srv/set_parameters.h>
#include <rcl_interfaces/srv/set_parameters_atomically.h>
#include <rmw/qos_profiles.h>
#include <rosidl_runtime_c/primitives_sequence_functions.h>
#include <rosidl_runtime_c/string_functions.h>

#include "messages.h"
#include "parts.h"

enum { REASON = 1000, QUEUED = 10 };

static bool assign(rosidl_runtime_c__String *string, const char *text)
{
    return rosidl_runtime_c__String__assign(string, text);
}

/* ---- Values */

static void to_value(const struct parameter *p, rcl_interfaces__msg__ParameterValue *value)
{
    value->type = (uint8_t)(p != NULL ? p->type : PARAMETER_UNSET);
    if (p == NULL)
        return;
    value->bool_value = p->type == PARAMETER_BOOL && p->value > 0.0;
    if (p->type == PARAMETER_INTEGER)
        value->integer_value = (int64_t)p->value;
    if (p->type == PARAMETER_DOUBLE)
        value->double_value = p->value;
}

static bool convert(const struct services *s, const rcl_interfaces__msg__Parameter *parameter,
                    double *value, char *reason)
{
    const char *name = parameter->name.data;
    const struct parameter_request request = { parameter->value.type, parameter->value.bool_value,
                                               parameter->value.integer_value,
                                               parameter->value.double_value };
    return parameters_convert(&s->parameters, parameters_find(&s->parameters, name), name, &request,
                              value, reason, REASON);
}

/* ---- Changes */

/* Publishes a new value on /parameter_events. */
static void publish_change(const struct services *s, const struct parameter *p)
{
    rcl_interfaces__msg__ParameterEvent event;
    const int64_t now_ns = node_stamp_ns();
    bool ok = rcl_interfaces__msg__ParameterEvent__init(&event);
    event.stamp.sec = (int32_t)(now_ns / 1000000000);
    event.stamp.nanosec = (uint32_t)(now_ns % 1000000000);
    ok = ok && assign(&event.node, rcl_node_get_fully_qualified_name(s->node)) &&
         rcl_interfaces__msg__Parameter__Sequence__init(&event.changed_parameters, 1) &&
         assign(&event.changed_parameters.data[0].name, p->name);
    if (ok) {
        to_value(p, &event.changed_parameters.data[0].value);
        if (rcl_publish(&s->events, &event, NULL) != RCL_RET_OK)
            rcl_reset_error();
    }
    rcl_interfaces__msg__ParameterEvent__fini(&event);
}

static bool send_touch(const struct services *s, const struct parameter *p, double value,
                       bool is_initial)
{
    struct ros_touch touch;
    memset(&touch, 0, sizeof touch);
    touch.head.size = (uint32_t)sizeof touch;
    touch.head.kind = ROS_TOUCH;
    touch.control = (uint32_t)p->control;
    touch.is_initial = is_initial;
    touch.value = value;
    return send(s->socket, &touch, sizeof touch, MSG_NOSIGNAL | MSG_DONTWAIT) ==
           (ssize_t)sizeof touch;
}

/* Sets a parameter that is not read-only. Returns false, with a reason, if the program cannot
 * receive the value. */
static bool set(struct services *s, const rcl_interfaces__msg__Parameter *parameter, double value,
                char *reason)
{
    struct parameter *p = parameters_find(&s->parameters, parameter->name.data);
    if (!send_touch(s, p, value, false)) {
        snprintf(reason, REASON, "the program is not running: try again later");
        return false;
    }
    p->value = value;
    publish_change(s, p);
    return true;
}

void services_set_initial(void *services, struct parameter *p, double value)
{
    struct services *s = (struct services *)services;
    if (send_touch(s, p, value, true))
        p->value = value;
}

void services_note(struct services *s, size_t control, double value)
{
    struct parameter *p;
    pthread_mutex_lock(&s->lock);
    p = parameters_of_control(&s->parameters, control);
    if (p != NULL && (p->value < value || p->value > value)) {
        p->value = value;
        publish_change(s, p);
    }
    pthread_mutex_unlock(&s->lock);
}

/* ---- The services. Each function fills in an initialized response. Returns false if
 * memory runs out. */

static bool set_parameters(struct services *s, const void *request, void *response)
{
    const rcl_interfaces__msg__Parameter__Sequence *wanted =
        &((const rcl_interfaces__srv__SetParameters_Request *)request)->parameters;
    rcl_interfaces__msg__SetParametersResult__Sequence *results =
        &((rcl_interfaces__srv__SetParameters_Response *)response)->results;
    if (!rcl_interfaces__msg__SetParametersResult__Sequence__init(results, wanted->size))
        return false;
    for (size_t i = 0; i < wanted->size; i++) {
        char reason[REASON] = "";
        double value;
        results->data[i].successful =
            convert(s, &wanted->data[i], &value, reason) && set(s, &wanted->data[i], value, reason);
        if (!assign(&results->data[i].reason, reason))
            return false;
    }
    return true;
}

static bool set_parameters_atomically(struct services *s, const void *request, void *response)
{
    const rcl_interfaces__msg__Parameter__Sequence *wanted =
        &((const rcl_interfaces__srv__SetParametersAtomically_Request *)request)->parameters;
    rcl_interfaces__msg__SetParametersResult *result =
        &((rcl_interfaces__srv__SetParametersAtomically_Response *)response)->result;
    char reason[REASON] = "";
    bool ok = true;
    double value;
    for (size_t i = 0; ok && i < wanted->size; i++)
        ok = convert(s, &wanted->data[i], &value, reason);
    for (size_t i = 0; ok && i < wanted->size; i++)
        ok =
            convert(s, &wanted->data[i], &value, reason) && set(s, &wanted->data[i], value, reason);
    result->successful = ok;
    return assign(&result->reason, reason);
}

static bool get_parameters(struct services *s, const void *request, void *response)
{
    const rosidl_runtime_c__String__Sequence *names =
        &((const rcl_interfaces__srv__GetParameters_Request *)request)->names;
    rcl_interfaces__msg__ParameterValue__Sequence *values =
        &((rcl_interfaces__srv__GetParameters_Response *)response)->values;
    if (!rcl_interfaces__msg__ParameterValue__Sequence__init(values, names->size))
        return false;
    for (size_t i = 0; i < names->size; i++)
        to_value(parameters_find(&s->parameters, names->data[i].data), &values->data[i]);
    return true;
}

static bool get_parameter_types(struct services *s, const void *request, void *response)
{
    const rosidl_runtime_c__String__Sequence *names =
        &((const rcl_interfaces__srv__GetParameterTypes_Request *)request)->names;
    rosidl_runtime_c__uint8__Sequence *types =
        &((rcl_interfaces__srv__GetParameterTypes_Response *)response)->types;
    if (!rosidl_runtime_c__uint8__Sequence__init(types, names->size))
        return false;
    for (size_t i = 0; i < names->size; i++) {
        const struct parameter *p = parameters_find(&s->parameters, names->data[i].data);
        types->data[i] = (uint8_t)(p != NULL ? p->type : PARAMETER_UNSET);
    }
    return true;
}

static bool describe(const struct parameter *p, const char *name,
                     rcl_interfaces__msg__ParameterDescriptor *descriptor)
{
    char text[ROS_NAME];
    if (!assign(&descriptor->name, name))
        return false;
    if (p == NULL)
        return true;
    parameters_describe(p, text, sizeof text);
    descriptor->type = (uint8_t)p->type;
    descriptor->read_only = p->is_fixed;
    if (!assign(&descriptor->description, text))
        return false;
    if (p->type == PARAMETER_INTEGER) {
        if (!rcl_interfaces__msg__IntegerRange__Sequence__init(&descriptor->integer_range, 1))
            return false;
        descriptor->integer_range.data[0].from_value = (int64_t)p->least;
        descriptor->integer_range.data[0].to_value = (int64_t)p->most;
    }
    if (p->type == PARAMETER_DOUBLE && !p->is_fixed) {
        if (!rcl_interfaces__msg__FloatingPointRange__Sequence__init(
                &descriptor->floating_point_range, 1))
            return false;
        descriptor->floating_point_range.data[0].from_value = p->least;
        descriptor->floating_point_range.data[0].to_value = p->most;
    }
    return true;
}

static bool describe_parameters(struct services *s, const void *request, void *response)
{
    const rosidl_runtime_c__String__Sequence *names =
        &((const rcl_interfaces__srv__DescribeParameters_Request *)request)->names;
    rcl_interfaces__msg__ParameterDescriptor__Sequence *descriptors =
        &((rcl_interfaces__srv__DescribeParameters_Response *)response)->descriptors;
    bool ok = rcl_interfaces__msg__ParameterDescriptor__Sequence__init(descriptors, names->size);
    for (size_t i = 0; ok && i < names->size; i++)
        ok = describe(parameters_find(&s->parameters, names->data[i].data), names->data[i].data,
                      &descriptors->data[i]);
    return ok;
}

/* Returns whether a name is below a prefix, at most `depth` levels deep, or at any depth if `depth`
 * is 0. */
static bool is_below(const char *name, const char *prefix, uint64_t depth)
{
    const size_t length = strlen(prefix);
    uint64_t levels = 1;
    if (length > 0) {
        if (strcmp(name, prefix) == 0)
            return true;
        if (strncmp(name, prefix, length) != 0 || name[length] != '.')
            return false;
        name += length + 1;
    }
    for (; *name != '\0'; name++)
        levels += *name == '.' ? 1 : 0;
    return depth == 0 || levels <= depth;
}

static bool is_listed(const char *name, const rcl_interfaces__srv__ListParameters_Request *request)
{
    bool listed = request->prefixes.size == 0 && is_below(name, "", request->depth);
    for (size_t i = 0; i < request->prefixes.size; i++)
        listed = listed || is_below(name, request->prefixes.data[i].data, request->depth);
    return listed;
}

static bool list_parameters(struct services *s, const void *request, void *response)
{
    const rcl_interfaces__srv__ListParameters_Request *wanted =
        (const rcl_interfaces__srv__ListParameters_Request *)request;
    rcl_interfaces__msg__ListParametersResult *result =
        &((rcl_interfaces__srv__ListParameters_Response *)response)->result;
    size_t count = 0;
    if (!rosidl_runtime_c__String__Sequence__init(&result->names, s->parameters.count))
        return false;
    for (size_t i = 0; i < s->parameters.count; i++) {
        const char *name = s->parameters.each[i].name;
        if (is_listed(name, wanted) && !assign(&result->names.data[count++], name))
            return false;
    }
    result->names.size = count; /* the capacity determines how many elements are freed */
    return true;
}

/* ---- The table of services */

/* Large enough for a request or response of any service. */
union message {
    rcl_interfaces__srv__SetParameters_Request set_parameters_request;
    rcl_interfaces__srv__SetParameters_Response set_parameters_response;
    rcl_interfaces__srv__SetParametersAtomically_Request set_parameters_atomically_request;
    rcl_interfaces__srv__SetParametersAtomically_Response set_parameters_atomically_response;
    rcl_interfaces__srv__GetParameters_Request get_parameters_request;
    rcl_interfaces__srv__GetParameters_Response get_parameters_response;
    rcl_interfaces__srv__GetParameterTypes_Request get_parameter_types_request;
    rcl_interfaces__srv__GetParameterTypes_Response get_parameter_types_response;
    rcl_interfaces__srv__DescribeParameters_Request describe_parameters_request;
    rcl_interfaces__srv__DescribeParameters_Response describe_parameters_response;
    rcl_interfaces__srv__ListParameters_Request list_parameters_request;
    rcl_interfaces__srv__ListParameters_Response list_parameters_response;
};

struct service {
    const char *name;
    const rosidl_service_type_support_t *(*type)(void);
    bool (*init)(union message *request, union message *response);
    void (*fini)(union message *request, union message *response);
    bool (*answer)(struct services *s, const void *request, void *response);
};

#define SERVICE_FUNCTIONS(Name, name)                                                    \
    static const rosidl_service_type_support_t *type_of_##name(void)                     \
    {                                                                                    \
        return ROSIDL_GET_SRV_TYPE_SUPPORT(rcl_interfaces, srv, Name);                   \
    }                                                                                    \
    static bool init_##name(union message *request, union message *response)             \
    {                                                                                    \
        return rcl_interfaces__srv__##Name##_Request__init(&request->name##_request) &&  \
               rcl_interfaces__srv__##Name##_Response__init(&response->name##_response); \
    }                                                                                    \
    static void fini_##name(union message *request, union message *response)             \
    {                                                                                    \
        rcl_interfaces__srv__##Name##_Request__fini(&request->name##_request);           \
        rcl_interfaces__srv__##Name##_Response__fini(&response->name##_response);        \
    }

SERVICE_FUNCTIONS(SetParameters, set_parameters)
SERVICE_FUNCTIONS(SetParametersAtomically, set_parameters_atomically)
SERVICE_FUNCTIONS(GetParameters, get_parameters)
SERVICE_FUNCTIONS(GetParameterTypes, get_parameter_types)
SERVICE_FUNCTIONS(DescribeParameters, describe_parameters)
SERVICE_FUNCTIONS(ListParameters, list_parameters)

#define SERVICE(name) { "~/" #name, type_of_##name, init_##name, fini_##name, name }

static const struct service table[SERVICES] = {
    SERVICE(set_parameters),      SERVICE(set_parameters_atomically), SERVICE(get_parameters),
    SERVICE(get_parameter_types), SERVICE(describe_parameters),       SERVICE(list_parameters),
};

const char *services_start(struct services *s, const rcl_node_t *node, int socket)
{
    rcl_publisher_options_t events = rcl_publisher_get_default_options();
    rcl_service_options_t options = rcl_service_get_default_options();
    static const char topic[] = "/parameter_events";
    s->node = node;
    s->socket = socket;
    pthread_mutex_init(&s->lock, NULL);
    options.qos = rmw_qos_profile_parameters;
    events.qos = rmw_qos_profile_parameter_events;
    /* These profiles have a queue depth of 1000, and Fast DDS would allocate the whole queue. */
    options.qos.depth = events.qos.depth = QUEUED;
    for (size_t i = 0; i < SERVICES; i++) {
        s->each[i] = rcl_get_zero_initialized_service();
        if (rcl_service_init(&s->each[i], node, table[i].type(), table[i].name, &options) !=
            RCL_RET_OK)
            return table[i].name;
    }
    s->events = rcl_get_zero_initialized_publisher();
    return rcl_publisher_init(&s->events, node,
                              ROSIDL_GET_MSG_TYPE_SUPPORT(rcl_interfaces, msg, ParameterEvent),
                              topic, &events) == RCL_RET_OK
               ? NULL
               : topic;
}

void services_take(struct services *s, size_t service)
{
    const struct service *of = &table[service];
    for (;;) {
        union message request, response;
        rmw_request_id_t id;
        bool taken;
        memset(&request, 0, sizeof request);
        memset(&response, 0, sizeof response);
        taken = of->init(&request, &response);
        if (taken && rcl_take_request(&s->each[service], &id, &request) != RCL_RET_OK) {
            rcl_reset_error(); /* there are no more requests */
            taken = false;
        }
        if (taken) {
            bool ok;
            pthread_mutex_lock(&s->lock);
            ok = of->answer(s, &request, &response);
            pthread_mutex_unlock(&s->lock);
            if (!ok || rcl_send_response(&s->each[service], &id, &response) != RCL_RET_OK)
                rcl_reset_error();
        }
        of->fini(&request, &response);
        if (!taken)
            return;
    }
}

bool services_end(struct services *s, rcl_node_t *node)
{
    bool ok = rcl_publisher_fini(&s->events, node) == RCL_RET_OK;
    for (size_t i = 0; i < SERVICES; i++)
        ok = rcl_service_fini(&s->each[i], node) == RCL_RET_OK && ok;
    return ok;
}
