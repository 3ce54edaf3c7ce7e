#include "inputs.h"
#include "parts.h"

#include <stdio.h>
#include <string.h>

#include <rcl/error_handling.h>
#include <rcl/graph.h>

#define CHECK_NS INT64_C(1000000000)

/* Time to wait for a publisher before reporting that there is none. */
#define SILENCE_NS INT64_C(2000000000)

/* Reports nodes that use a different type on the topic. DDS neither connects such nodes nor reports
 * the mismatch. `their`: "publishes" or "subscribes to". */
static void tell_type(struct topic *topic, const rcl_topic_endpoint_info_array_t *nodes,
                      const char *their)
{
    for (size_t i = 0; i < nodes->size && !topic->told; i++) {
        const rcl_topic_endpoint_info_t *other = &nodes->info_array[i];
        if (strcmp(other->topic_type, topic->type) == 0)
            continue;
        topic->told = true;
        fprintf(
            stderr,
            "warning: %s has two types, so no message gets through: the node %s %s %s, but this "
            "program needs %s%s\n",
            topic->name, other->node_name, their, other->topic_type, topic->type,
            topic->cure != NULL && strcmp(other->topic_type, "geometry_msgs/msg/TwistStamped") == 0
                ? topic->cure
                : "");
    }
}

/* Reports a subscriber that also requests earlier messages. DDS connects such a subscriber only to
 * publishers that keep earlier messages, and silently refuses all others. */
static void tell_durability(struct topic *topic, const rcl_topic_endpoint_info_array_t *nodes)
{
    for (size_t i = 0; i < nodes->size && !topic->told_durability; i++) {
        const rcl_topic_endpoint_info_t *other = &nodes->info_array[i];
        if (other->qos_profile.durability != RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL)
            continue;
        topic->told_durability = true;
        fprintf(
            stderr,
            "warning: the node %s subscribes to %s with the durability `transient local`, so no "
            "message gets through: %s are not kept. Set the durability of its subscription to "
            "`volatile`\n",
            other->node_name, topic->name, topic->kept);
    }
}

/* Reports a publisher with best-effort delivery on a topic whose messages must not be lost. DDS
 * does not connect such a publisher to this node. */
static void tell_reliability(struct topic *topic, const rcl_topic_endpoint_info_array_t *nodes)
{
    for (size_t i = 0; i < nodes->size && !topic->told_reliability; i++) {
        const rcl_topic_endpoint_info_t *other = &nodes->info_array[i];
        if (other->qos_profile.reliability != RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT)
            continue;
        topic->told_reliability = true;
        fprintf(
            stderr,
            "warning: the node %s publishes %s with the reliability `best effort`, so no message "
            "gets through: set the reliability of its publisher to `reliable`\n",
            other->node_name, topic->name);
    }
}

static void look_at_input(const struct graph *g, struct input *input, const rcl_node_t *node)
{
    rcutils_allocator_t allocator = rcutils_get_default_allocator();
    rcl_topic_endpoint_info_array_t nodes = rcl_get_zero_initialized_topic_endpoint_info_array();
    struct topic *topic = &input->topic;
    if (rcl_get_publishers_info_by_topic(node, &allocator, topic->name, false, &nodes) !=
        RCL_RET_OK) {
        rcl_reset_error();
        return;
    }
    tell_type(topic, &nodes, "publishes");
    if (inputs_is_reliable(input))
        tell_reliability(topic, &nodes);
    if (nodes.size == 0 && inputs_is_needed(input) && !input->heard && !topic->told_silence &&
        node_now_ns() - g->started_ns > SILENCE_NS) {
        topic->told_silence = true;
        fprintf(stderr,
                "warning: no node publishes %s (%s), which the program needs. Start the robot's "
                "nodes, or remap the topic with `--ros-args -r %s:=NAME`\n",
                topic->name, topic->type, input->name);
    }
    if (rcl_topic_endpoint_info_array_fini(&nodes, &allocator) != RCL_RET_OK)
        rcl_reset_error();
}

static void look_at_output(struct topic *topic, const rcl_node_t *node)
{
    rcutils_allocator_t allocator = rcutils_get_default_allocator();
    rcl_topic_endpoint_info_array_t nodes = rcl_get_zero_initialized_topic_endpoint_info_array();
    if (rcl_get_subscriptions_info_by_topic(node, &allocator, topic->name, false, &nodes) !=
        RCL_RET_OK) {
        rcl_reset_error();
        return;
    }
    tell_type(topic, &nodes, "subscribes to");
    tell_durability(topic, &nodes);
    if (rcl_topic_endpoint_info_array_fini(&nodes, &allocator) != RCL_RET_OK)
        rcl_reset_error();
}

static void look_at_names(struct graph *g, const rcl_node_t *node)
{
    const char *name = rcl_node_get_name(node), *space = rcl_node_get_namespace(node);
    rcutils_string_array_t names = rcutils_get_zero_initialized_string_array();
    rcutils_string_array_t spaces = rcutils_get_zero_initialized_string_array();
    size_t same = 0;
    if (g->told_name)
        return;
    if (rcl_get_node_names(node, rcl_get_default_allocator(), &names, &spaces) != RCL_RET_OK) {
        rcl_reset_error();
        return;
    }
    for (size_t i = 0; i < names.size; i++)
        if (strcmp(names.data[i], name) == 0 && strcmp(spaces.data[i], space) == 0)
            same++;
    if (same > 1) {
        g->told_name = true;
        fprintf(stderr,
                "warning: there is another node named %s; rename this one with `--ros-args "
                "-r __node:=NAME`\n",
                rcl_node_get_fully_qualified_name(node));
    }
    if (rcutils_string_array_fini(&names) != RCUTILS_RET_OK ||
        rcutils_string_array_fini(&spaces) != RCUTILS_RET_OK)
        rcutils_reset_error();
}

void graph_look(struct graph *g, const rcl_node_t *node)
{
    const int64_t now = node_now_ns();
    if (now - g->checked_ns < CHECK_NS)
        return;
    g->checked_ns = now;
    for (size_t i = 0; i < g->inputs->count; i++)
        look_at_input(g, &g->inputs->each[i], node);
    for (size_t i = 0; i < g->published_count; i++)
        look_at_output(&g->published[i], node);
    look_at_names(g, node);
}
