#include "diagnostics.h"

#include <stdio.h>

#include <diagnostic_msgs/msg/diagnostic_status.h>
#include <rcl/error_handling.h>
#include <rosidl_runtime_c/string_functions.h>

#include "late.h"
#include "parts.h"

#define DIAGNOSTIC(function) LATE("diagnostic_msgs__rosidl_generator_c", function)

bool diagnostics_start(struct diagnostics *d, const struct frob_program *program,
                       const rcl_node_t *node, char *why, size_t room)
{
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    d->count = program->claim_count;
    if (d->count == 0)
        return true;
    if (!late_messages("diagnostic_msgs", why, room) ||
        !DIAGNOSTIC(diagnostic_msgs__msg__DiagnosticArray__init)(&d->message) ||
        !DIAGNOSTIC(diagnostic_msgs__msg__DiagnosticStatus__Sequence__init)(&d->message.status,
                                                                            d->count))
        return false;
    for (size_t i = 0; i < d->count; i++) {
        char name[2 * ROS_NAME + 4];
        snprintf(name, sizeof name, "%.255s: %.255s", rcl_node_get_name(node),
                 program->claims[i].label);
        if (!rosidl_runtime_c__String__assign(&d->message.status.data[i].name, name) ||
            !rosidl_runtime_c__String__assign(&d->message.status.data[i].hardware_id,
                                              program->claims[i].place))
            return false;
    }
    d->publisher = rcl_get_zero_initialized_publisher();
    return rcl_publisher_init(&d->publisher, node,
                              late_message_type("diagnostic_msgs", "DiagnosticArray"),
                              "/diagnostics", &options) == RCL_RET_OK;
}

void diagnostics_take(struct diagnostics *d, const struct ros_claim *claim)
{
    const int64_t now_ns = node_stamp_ns();
    diagnostic_msgs__msg__DiagnosticStatus *status;
    if (claim->claim >= d->count)
        return;
    status = &d->message.status.data[claim->claim];
    status->level = claim->level;
    if (!rosidl_runtime_c__String__assign(&status->message, claim->fate) ||
        claim->claim + 1 < d->count)
        return;
    d->message.header.stamp.sec = (int32_t)(now_ns / 1000000000);
    d->message.header.stamp.nanosec = (uint32_t)(now_ns % 1000000000);
    if (rcl_publish(&d->publisher, &d->message, NULL) != RCL_RET_OK)
        rcl_reset_error();
}

bool diagnostics_end(struct diagnostics *d, rcl_node_t *node)
{
    return d->count == 0 || rcl_publisher_fini(&d->publisher, node) == RCL_RET_OK;
}
