#include "node.h"

#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <rcl/error_handling.h>
#include <rcl/rcl.h>
#include <rmw/qos_profiles.h>
#include <rosidl_runtime_c/string_functions.h>
#include <std_msgs/msg/string.h>

#include "inputs.h"
#include "lifecycle.h"
#include "diagnostics.h"
#include "markers.h"
#include "messages.h"
#include "outputs.h"
#include "overrides.h"
#include "parts.h"
#include "services.h"

#define WAIT_NS INT64_C(500000000)

/* Maximum time to wait for subscribers to acknowledge the last velocity. */
#define ACKNOWLEDGED_NS INT64_C(100000000)

/* Number of past instants that a late subscriber, such as a bag recorder, receives. */
enum { INSTANTS_KEPT = 500 };

enum { DONE = 0, FAULT = 2 };

struct node {
    const struct node_options *options;
    rcl_context_t context;
    rcl_node_t node;
    struct inputs inputs;
    struct services services;
    struct outputs outputs;
    rcl_publisher_t columns, instants;
    std_msgs__msg__String text;
    struct diagnostics diagnostics;
    struct markers markers;
    struct lifecycle lifecycle;
    rcl_guard_condition_t over; /* triggered when the supervisor has exited */
    bool is_over;               /* accessed atomically */
    struct graph graph;
};

/* The only node of this process. */
static struct node the_node;

int64_t node_stamp_ns(void)
{
    struct timespec now;
    if (the_node.options->use_sim_time)
        return __atomic_load_n(&the_node.inputs.clock_ns, __ATOMIC_SEQ_CST);
    clock_gettime(CLOCK_REALTIME, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

int64_t node_now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

/* ---- Joining the ROS 2 system */

/* Tells the supervisor why the node cannot start. */
static void refuse_because(const struct node *n, const char *what, const char *why)
{
    struct ros_refused refused;
    memset(&refused, 0, sizeof refused);
    refused.head.size = (uint32_t)sizeof refused;
    refused.head.kind = ROS_REFUSED;
    snprintf(refused.reason, sizeof refused.reason, "%s: %s", what, why);
    if (send(n->options->socket, &refused, sizeof refused, MSG_NOSIGNAL) < 0)
        fprintf(stderr, "error: %s\n", refused.reason);
}

/* Tells the supervisor why the node cannot start, with the reason that rcl reports. */
static void refuse(const struct node *n, const char *what)
{
    refuse_because(n, what, rcl_get_error_string().str);
    rcl_reset_error();
}

static bool join(struct node *n)
{
    rcl_allocator_t allocator = rcl_get_default_allocator();
    rcl_init_options_t init = rcl_get_zero_initialized_init_options();
    rcl_node_options_t options = rcl_node_get_default_options();
    rcl_ret_t result;
    if (rcl_init_options_init(&init, allocator) != RCL_RET_OK) {
        refuse(n, "cannot initialize ROS 2");
        return false;
    }
    n->context = rcl_get_zero_initialized_context();
    result = rcl_init(n->options->argc, (char const *const *)n->options->argv, &init, &n->context);
    if (rcl_init_options_fini(&init) != RCL_RET_OK)
        rcl_reset_error();
    if (result != RCL_RET_OK) {
        refuse(n, result == RCL_RET_INVALID_ROS_ARGS ? "invalid argument after --ros-args"
                                                     : "cannot initialize ROS 2");
        return false;
    }
    n->node = rcl_get_zero_initialized_node();
    if (rcl_node_init(&n->node, n->options->program->name, "", &n->context, &options) !=
        RCL_RET_OK) {
        refuse(n, "cannot create the node");
        return false;
    }
    return true;
}

static bool subscribe(struct node *n)
{
    const char *failed;
    char why[ROS_REASON];
    if (!inputs_of(&n->inputs, n->options->program, n->options->use_sim_time,
                   n->options->has_joystick, why, sizeof why)) {
        refuse_because(n, "cannot subscribe", why);
        return false;
    }
    failed = inputs_subscribe(&n->inputs, &n->node);
    if (failed != NULL) {
        char what[ROS_NAME + 32];
        snprintf(what, sizeof what, "cannot subscribe to %s", failed);
        refuse(n, what);
    }
    return failed == NULL;
}

static bool serve(struct node *n)
{
    const struct node_options *o = n->options;
    const char *failed;
    if (!parameters_of(&n->services.parameters, o->program, o->params, o->use_sim_time)) {
        refuse_because(n, "cannot offer parameters", "not enough memory");
        return false;
    }
    failed = services_start(&n->services, &n->node, o->socket);
    if (failed != NULL) {
        char what[ROS_NAME + 32];
        snprintf(what, sizeof what, "cannot offer %s", failed);
        refuse(n, what);
    }
    return failed == NULL;
}

static bool advertise(struct node *n)
{
    char why[ROS_REASON];
    if (!outputs_start(&n->outputs, n->options->program, n->options->stamped, &n->node, why,
                       sizeof why)) {
        const size_t length = strlen(why);
        if (length > 0 && why[length - 1] == ':') {
            why[length - 1] = '\0';
            refuse(n, why);
        } else {
            refuse_because(n, "cannot publish", why);
        }
        return false;
    }
    n->over = rcl_get_zero_initialized_guard_condition();
    if (rcl_guard_condition_init(&n->over, &n->context,
                                 rcl_guard_condition_get_default_options()) != RCL_RET_OK) {
        refuse(n, "cannot initialize ROS 2");
        return false;
    }
    return true;
}

/* Late subscribers receive the columns, and the newest instants. */
static bool advertise_text(struct node *n, rcl_publisher_t *publisher, const char *topic,
                           size_t depth)
{
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    options.qos.depth = depth;
    options.qos.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
    *publisher = rcl_get_zero_initialized_publisher();
    if (rcl_publisher_init(publisher, &n->node, ROSIDL_GET_MSG_TYPE_SUPPORT(std_msgs, msg, String),
                           topic, &options) == RCL_RET_OK)
        return true;
    refuse(n, "cannot publish the instants");
    return false;
}

static bool advertise_instants(struct node *n)
{
    return std_msgs__msg__String__init(&n->text) &&
           advertise_text(n, &n->columns, "~/columns", 1) &&
           advertise_text(n, &n->instants, "~/instants", INSTANTS_KEPT);
}

/* Tells the supervisor that a part of the node cannot start. The reason is `why` or, if `why` is
 * empty, the one that rcl reports. */
static bool lacks(const struct node *n, const char *what, const char *why)
{
    if (why[0] != '\0')
        refuse_because(n, what, why);
    else
        refuse(n, what);
    return false;
}

static bool diagnose(struct node *n)
{
    char why[ROS_REASON] = "";
    return diagnostics_start(&n->diagnostics, n->options->program, &n->node, why, sizeof why) ||
           lacks(n, "cannot publish /diagnostics", why);
}

static bool mark(struct node *n)
{
    char why[ROS_REASON] = "";
    return markers_start(&n->markers, n->options->program, &n->node, why, sizeof why) ||
           lacks(n, "cannot publish ~/markers", why);
}

static void rest(void *of)
{
    outputs_rest(&((struct node *)of)->outputs);
}

static bool manage(struct node *n)
{
    char why[ROS_REASON] = "";
    return lifecycle_start(&n->lifecycle, n->options->is_managed, &n->node, n->options->socket,
                           rest, n, why, sizeof why) ||
           lacks(n, "cannot be a managed node", why);
}

/* Tells the supervisor the name of one of the program's own topics. */
static bool report_name(const struct node *n, uint32_t topic, bool is_output, const char *name)
{
    struct ros_named named;
    memset(&named, 0, sizeof named);
    named.head.size = (uint32_t)sizeof named;
    named.head.kind = ROS_NAMED;
    named.topic = topic;
    named.is_output = is_output;
    snprintf(named.name, sizeof named.name, "%s", name);
    return send(n->options->socket, &named, sizeof named, MSG_NOSIGNAL) >= 0;
}

static bool report_names(const struct node *n)
{
    bool ok = true;
    if (n->options->program->node == NULL)
        return true;
    for (size_t i = 0; i < n->inputs.count; i++)
        if (n->inputs.each[i].kind == ROS_TOPIC)
            ok = ok &&
                 report_name(n, n->inputs.each[i].own.number, false, n->inputs.each[i].topic.name);
    for (size_t i = 0; i < n->outputs.count; i++)
        ok = ok && report_name(n, (uint32_t)i, true, n->outputs.topics[i].name);
    return ok;
}

/* Tells the supervisor the names of the node and its topics, after remapping. */
static bool report(struct node *n)
{
    struct ros_started started;
    memset(&started, 0, sizeof started);
    started.head.size = (uint32_t)sizeof started;
    started.head.kind = ROS_STARTED;
    n->graph.started_ns = node_now_ns();
    n->graph.inputs = &n->inputs;
    n->graph.published = n->outputs.topics;
    n->graph.published_count = n->outputs.count;
    snprintf(started.node, sizeof started.node, "%s", rcl_node_get_fully_qualified_name(&n->node));
    if (n->options->program->node == NULL) {
        snprintf(started.odometry, sizeof started.odometry, "%s", n->inputs.each[0].topic.name);
        snprintf(started.velocity, sizeof started.velocity, "%s", n->outputs.topics[0].name);
    }
    for (size_t i = 0; i < n->inputs.count; i++) {
        const struct input *input = &n->inputs.each[i];
        const size_t k = started.sensor_count;
        if (input->kind == ROS_JOY)
            snprintf(started.joy, sizeof started.joy, "%s", input->topic.name);
        if (input->kind == ROS_CLICK)
            snprintf(started.click, sizeof started.click, "%s", input->topic.name);
        if (!inputs_is_sensor(input))
            continue;
        started.sensors[k].control = input->control;
        snprintf(started.sensors[k].topic, sizeof started.sensors[k].topic, "%s",
                 input->topic.name);
        started.sensor_count++;
    }
    if (send(n->options->socket, &started, sizeof started, MSG_NOSIGNAL) < 0 || !report_names(n))
        return false;
    overrides_of_controls(n->options->argc, n->options->argv, n->options->program->name,
                          &n->services.parameters, services_set_initial, &n->services);
    return true;
}

/* ---- Publishing */

/* If the node is active, publishes a velocity, the program's own topics, or zeros. */
static void publish_if_active(struct node *n, const struct ros_velocity *velocity,
                              const struct ros_output *output)
{
    pthread_mutex_lock(&n->lifecycle.lock);
    if (n->lifecycle.is_active && velocity != NULL)
        outputs_drive(&n->outputs, velocity->speed_m_s, velocity->turn_rad_s);
    else if (n->lifecycle.is_active && output != NULL)
        outputs_publish(&n->outputs, output + 1, output->rests);
    else if (n->lifecycle.is_active)
        outputs_rest(&n->outputs);
    pthread_mutex_unlock(&n->lifecycle.lock);
}

/* Publishes an instant, preceded by its number and a space. */
static void publish_text(struct node *n, const struct ros_text *text)
{
    static char buffer[ROS_TEXT_MOST + 32];
    const int length = (int)(text->head.size - sizeof *text);
    const rcl_publisher_t *publisher = text->number < 0 ? &n->columns : &n->instants;
    if (text->number < 0)
        snprintf(buffer, sizeof buffer, "%.*s", length, (const char *)(text + 1));
    else
        snprintf(buffer, sizeof buffer, "%lld %.*s", (long long)text->number, length,
                 (const char *)(text + 1));
    if (!rosidl_runtime_c__String__assign(&n->text.data, buffer) ||
        rcl_publish(publisher, &n->text, NULL) != RCL_RET_OK)
        rcl_reset_error();
}

/* The thread that publishes. It ends when no other process has the other end of the socket open. */
static void *publish_all(void *of)
{
    struct node *n = (struct node *)of;
    for (;;) {
        static union {
            struct ros_head head;
            struct ros_velocity velocity;
            struct ros_output output;
            struct ros_touch touch;
            struct ros_text text;
            struct ros_claim claim;
            struct ros_marks marks;
            char bytes[ROS_MESSAGE_MOST];
        } message;
        ssize_t got = recv(n->options->socket, &message, sizeof message, 0);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < (ssize_t)sizeof message.head || got != (ssize_t)message.head.size)
            break;
        if (message.head.kind == ROS_VELOCITY)
            publish_if_active(n, &message.velocity, NULL);
        else if (message.head.kind == ROS_OUTPUT)
            publish_if_active(n, NULL, &message.output);
        else if (message.head.kind == ROS_REST)
            publish_if_active(n, NULL, NULL);
        else if (message.head.kind == ROS_TEXT)
            publish_text(n, &message.text);
        else if (message.head.kind == ROS_CLAIM)
            diagnostics_take(&n->diagnostics, &message.claim);
        else if (message.head.kind == ROS_MARKS)
            markers_take(&n->markers, &message.marks, &n->inputs.tf);
        else if (message.head.kind == ROS_TOUCH)
            services_note(&n->services, message.touch.control, message.touch.value);
    }
    publish_if_active(n, NULL, NULL);
    outputs_wait(&n->outputs, ACKNOWLEDGED_NS);
    __atomic_store_n(&n->is_over, true, __ATOMIC_SEQ_CST);
    if (rcl_trigger_guard_condition(&n->over) != RCL_RET_OK)
        rcl_reset_error();
    return NULL;
}

/* ---- Messages */

static bool prepare(struct node *n, rcl_wait_set_t *set)
{
    bool ok = rcl_wait_set_clear(set) == RCL_RET_OK;
    for (size_t i = 0; i < n->inputs.count; i++)
        ok = ok && rcl_wait_set_add_subscription(set, &n->inputs.each[i].subscription, NULL) ==
                       RCL_RET_OK;
    for (size_t i = 0; i < SERVICES; i++)
        ok = ok && rcl_wait_set_add_service(set, &n->services.each[i], NULL) == RCL_RET_OK;
    for (size_t i = 0; i < lifecycle_services(&n->lifecycle); i++)
        ok = ok &&
             rcl_wait_set_add_service(set, lifecycle_service(&n->lifecycle, i), NULL) == RCL_RET_OK;
    return ok && rcl_wait_set_add_guard_condition(set, &n->over, NULL) == RCL_RET_OK;
}

static int listen_until_over(struct node *n)
{
    rcl_wait_set_t set = rcl_get_zero_initialized_wait_set();
    if (rcl_wait_set_init(&set, n->inputs.count, 1, 0, 0,
                          SERVICES + lifecycle_services(&n->lifecycle), 0, &n->context,
                          rcl_get_default_allocator()) != RCL_RET_OK) {
        fprintf(stderr, "error: %s\n", rcl_get_error_string().str);
        return FAULT;
    }
    while (!__atomic_load_n(&n->is_over, __ATOMIC_SEQ_CST)) {
        rcl_ret_t result;
        if (!prepare(n, &set)) {
            fprintf(stderr, "error: %s\n", rcl_get_error_string().str);
            return FAULT;
        }
        result = rcl_wait(&set, WAIT_NS);
        if (result != RCL_RET_OK)
            rcl_reset_error();
        /* rcl_wait has set the subscriptions and services without messages to NULL. */
        for (size_t i = 0; result == RCL_RET_OK && i < n->inputs.count; i++)
            if (set.subscriptions[i] != NULL)
                inputs_take(&n->inputs, &n->inputs.each[i], n->options->socket);
        for (size_t i = 0; result == RCL_RET_OK && i < SERVICES; i++)
            if (set.services[i] != NULL)
                services_take(&n->services, i);
        for (size_t i = 0; result == RCL_RET_OK && i < lifecycle_services(&n->lifecycle); i++)
            if (set.services[SERVICES + i] != NULL)
                lifecycle_take(&n->lifecycle, i);
        graph_look(&n->graph, &n->node);
    }
    if (rcl_wait_set_fini(&set) != RCL_RET_OK)
        rcl_reset_error();
    return DONE;
}

/* ---- The process */

/* Leaves the terminal's session, so that a signal to the session does not keep the node from
 * publishing zero. */
static void leave_session(void)
{
    static const int ignored[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGPIPE };
    sigset_t none;
    setsid();
    for (size_t i = 0; i < sizeof ignored / sizeof ignored[0]; i++)
        signal(ignored[i], SIG_IGN);
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

/* Leaves the ROS 2 system, so that other nodes do not wait for this one. */
static void leave(struct node *n)
{
    bool ok = true;
    for (size_t i = 0; i < n->inputs.count; i++)
        ok = rcl_subscription_fini(&n->inputs.each[i].subscription, &n->node) == RCL_RET_OK && ok;
    ok = outputs_end(&n->outputs, &n->node) && ok;
    ok = rcl_publisher_fini(&n->columns, &n->node) == RCL_RET_OK && ok;
    ok = rcl_publisher_fini(&n->instants, &n->node) == RCL_RET_OK && ok;
    ok = markers_end(&n->markers, &n->node) && ok;
    ok = diagnostics_end(&n->diagnostics, &n->node) && ok;
    ok = services_end(&n->services, &n->node) && ok;
    ok = lifecycle_end(&n->lifecycle, &n->node) && ok;
    ok = rcl_guard_condition_fini(&n->over) == RCL_RET_OK && ok;
    ok = rcl_node_fini(&n->node) == RCL_RET_OK && ok;
    ok = rcl_shutdown(&n->context) == RCL_RET_OK && ok;
    ok = rcl_context_fini(&n->context) == RCL_RET_OK && ok;
    if (!ok)
        rcl_reset_error();
}

int node_run(const struct node_options *options)
{
    struct node *n = &the_node;
    pthread_t publisher;
    int status;
    n->options = options;
    leave_session();
    if (!join(n) || !subscribe(n) || !serve(n) || !advertise(n) || !advertise_instants(n) ||
        !diagnose(n) || !mark(n) || !manage(n) || !report(n))
        return FAULT;
    if (pthread_create(&publisher, NULL, publish_all, n) != 0) {
        fprintf(stderr, "error: cannot start a thread\n");
        return FAULT;
    }
    status = listen_until_over(n);
    if (status == DONE && pthread_join(publisher, NULL) == 0)
        leave(n);
    return status;
}
