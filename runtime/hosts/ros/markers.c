#include "markers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <geometry_msgs/msg/point.h>
#include <rcl/error_handling.h>
#include <rosidl_runtime_c/string_functions.h>
#include <visualization_msgs/msg/marker.h>

#include "drawing.h"
#include "late.h"
#include "topics.h"

typedef visualization_msgs__msg__Marker marker_type;

/* Number of sides of the polygon that approximates a circle. No other marker has more points. */
enum { SIDES = 36, POINTS_MOST = SIDES + 1 };

/* Maximum time to wait for subscribers to acknowledge the removal of all markers. */
#define ACKNOWLEDGED_NS INT64_C(100000000)

/* Sizes in metres. */
static const double line_width = 0.02, head_width = 0.06, cross_size = 0.05, text_height = 0.12;

#define VISUALIZATION(function) LATE("visualization_msgs__rosidl_generator_c", function)

bool markers_start(struct markers *m, const struct frob_program *program, const rcl_node_t *node,
                   char *why, size_t room)
{
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    m->drawing = drawing_of(program);
    if (m->drawing == NULL)
        return true;
    if (!late_messages("visualization_msgs", why, room))
        return false;
    m->room = drawing_room(m->drawing);
    m->output = (char *)calloc(1, program->output_size + 1);
    if (m->output == NULL ||
        !VISUALIZATION(visualization_msgs__msg__MarkerArray__init)(&m->message) ||
        !VISUALIZATION(visualization_msgs__msg__Marker__Sequence__init)(&m->message.markers,
                                                                        m->room))
        return false;
    for (size_t i = 0; i < m->room; i++) {
        marker_type *marker = &m->message.markers.data[i];
        if (!geometry_msgs__msg__Point__Sequence__init(&marker->points, POINTS_MOST) ||
            !rosidl_runtime_c__String__assign(&marker->ns, rcl_node_get_name(node)))
            return false;
        marker->id = (int32_t)i;
    }
    options.qos.depth = 1;
    m->publisher = rcl_get_zero_initialized_publisher();
    return rcl_publisher_init(&m->publisher, node,
                              late_message_type("visualization_msgs", "MarkerArray"), "~/markers",
                              &options) == RCL_RET_OK;
}

/* ---- Shapes */

static void add(marker_type *marker, double x, double y)
{
    geometry_msgs__msg__Point *point = &marker->points.data[marker->points.size++];
    point->x = x;
    point->y = y;
    point->z = 0.0;
}

static void set_lines(marker_type *marker, const struct drawing_mark *mark)
{
    marker->type = mark->shape == DRAWING_ARROW ? visualization_msgs__msg__Marker__ARROW
                                                : visualization_msgs__msg__Marker__LINE_STRIP;
    if (mark->shape == DRAWING_ARROW)
        marker->scale.y = head_width;
    add(marker, mark->at[0], mark->at[1]);
    add(marker, mark->at[2], mark->at[3]);
}

static void set_circle(marker_type *marker, const struct drawing_mark *mark)
{
    marker->type = visualization_msgs__msg__Marker__LINE_STRIP;
    for (int i = 0; i <= SIDES; i++) {
        const double angle = 2.0 * acos(-1.0) * (i % SIDES) / SIDES;
        add(marker, mark->at[0] + mark->at[2] * cos(angle), mark->at[1] + mark->at[2] * sin(angle));
    }
}

static void set_box(marker_type *marker, const struct drawing_mark *mark)
{
    static const double corners[5][2] = {
        { -0.5, -0.5 }, { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 }, { -0.5, -0.5 }
    };
    const double c = cos(mark->at[2]), s = sin(mark->at[2]);
    marker->type = visualization_msgs__msg__Marker__LINE_STRIP;
    for (size_t i = 0; i < 5; i++) {
        const double along = corners[i][0] * mark->at[3], across = corners[i][1] * mark->at[4];
        add(marker, mark->at[0] + c * along - s * across, mark->at[1] + s * along + c * across);
    }
}

static void set_cross(marker_type *marker, const struct drawing_mark *mark)
{
    const double x = mark->at[0], y = mark->at[1], d = cross_size;
    marker->type = visualization_msgs__msg__Marker__LINE_LIST;
    add(marker, x - d, y - d);
    add(marker, x + d, y + d);
    add(marker, x - d, y + d);
    add(marker, x + d, y - d);
}

static bool set_label(marker_type *marker, const struct drawing_mark *mark)
{
    marker->type = visualization_msgs__msg__Marker__TEXT_VIEW_FACING;
    marker->pose.position.x = mark->at[0];
    marker->pose.position.y = mark->at[1];
    marker->scale.x = 0.0;
    marker->scale.z = text_height;
    return rosidl_runtime_c__String__assign(&marker->text, mark->text);
}

static bool set_marker(marker_type *marker, const struct drawing_mark *mark, const struct tf *tf)
{
    marker->action = visualization_msgs__msg__Marker__ADD;
    /* With a stamp of 0, viewers use the newest transform. */
    marker->frame_locked = true;
    marker->color.r = mark->red;
    marker->color.g = mark->green;
    marker->color.b = mark->blue;
    marker->color.a = 1.0f;
    marker->points.size = 0;
    marker->pose.position.x = marker->pose.position.y = 0.0;
    marker->pose.orientation.w = 1.0;
    marker->scale.x = line_width;
    marker->scale.y = marker->scale.z = 0.0;
    switch (mark->shape) {
    case DRAWING_LINE:
    case DRAWING_ARROW: set_lines(marker, mark); break;
    case DRAWING_CIRCLE: set_circle(marker, mark); break;
    case DRAWING_BOX: set_box(marker, mark); break;
    case DRAWING_CROSS: set_cross(marker, mark); break;
    case DRAWING_LABEL:
        if (!set_label(marker, mark))
            return false;
    }
    return rosidl_runtime_c__String__assign(&marker->header.frame_id,
                                            mark->is_on_robot ? tf->robot : tf->odometry);
}

/* ---- Messages */

static void publish(struct markers *m, size_t count)
{
    /* Remove the markers that are no longer drawn. */
    for (size_t i = count; i < m->shown; i++)
        m->message.markers.data[i].action = visualization_msgs__msg__Marker__DELETE;
    m->message.markers.size = count > m->shown ? count : m->shown;
    m->shown = count;
    if (m->message.markers.size > 0 && rcl_publish(&m->publisher, &m->message, NULL) != RCL_RET_OK)
        rcl_reset_error();
    m->message.markers.size = m->room;
}

void markers_take(struct markers *m, const struct ros_marks *marks, const struct tf *tf)
{
    struct topic_span span;
    size_t count = 0, subscribers = 0;
    if (m->drawing == NULL ||
        rcl_publisher_get_subscription_count(&m->publisher, &subscribers) != RCL_RET_OK ||
        subscribers == 0)
        return;
    span = topic_span_of(m->drawing);
    if (marks->head.size != sizeof *marks + span.end - span.first)
        return;
    memcpy(m->output + span.first, marks + 1, span.end - span.first);
    for (size_t i = 0; i < m->room; i++) {
        struct drawing_mark mark;
        if (drawing_read(m->drawing, i, m->output, &mark) &&
            set_marker(&m->message.markers.data[count], &mark, tf))
            count++;
    }
    publish(m, count);
}

bool markers_end(struct markers *m, rcl_node_t *node)
{
    if (m->drawing == NULL)
        return true;
    publish(m, 0);
    if (rcl_publisher_wait_for_all_acked(&m->publisher, ACKNOWLEDGED_NS) != RCL_RET_OK)
        rcl_reset_error();
    return rcl_publisher_fini(&m->publisher, node) == RCL_RET_OK;
}
