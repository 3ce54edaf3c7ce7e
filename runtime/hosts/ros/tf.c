#include "tf.h"

#include <stdio.h>
#include <string.h>

#include "late.h"

const rosidl_message_type_support_t *tf_type(void)
{
    return late_message_type("tf2_msgs", "TFMessage");
}

/* Copies the name of a frame. If the message does not contain one, keeps the current
 * name. */
static void copy_name(char name[ROS_FRAME], const rosidl_runtime_c__String *from)
{
    /* Another thread reads the name (markers.h), so it is only written when it changes. */
    if (from->data != NULL && from->data[0] != '\0' && strlen(from->data) < ROS_FRAME &&
        strcmp(name, frames_name(from->data)) != 0)
        snprintf(name, ROS_FRAME, "%s", frames_name(from->data));
}

void tf_start(struct tf *tf)
{
    snprintf(tf->odometry, sizeof tf->odometry, "odom");
    snprintf(tf->robot, sizeof tf->robot, "base_link");
}

void tf_name(struct tf *tf, const nav_msgs__msg__Odometry *odometry)
{
    copy_name(tf->odometry, &odometry->header.frame_id);
    copy_name(tf->robot, &odometry->child_frame_id);
}

void tf_take(struct tf *tf, const struct tf_message *message, const char *topic, bool is_fixed,
             int64_t now_ns)
{
    for (size_t i = 0; i < message->transforms.size; i++) {
        const geometry_msgs__msg__TransformStamped *t = &message->transforms.data[i];
        const geometry_msgs__msg__Vector3 *at = &t->transform.translation;
        const geometry_msgs__msg__Quaternion *q = &t->transform.rotation;
        const struct frames_pose pose = { { at->x, at->y, at->z }, { q->x, q->y, q->z, q->w } };
        const char *parent = t->header.frame_id.data, *name = t->child_frame_id.data;
        const char *bad = parent == NULL || name == NULL
                              ? "the name of a frame is missing"
                              : frames_put(&tf->frames, parent, name, &pose, is_fixed, now_ns);
        if (bad != NULL && !tf->told)
            fprintf(stderr,
                    "warning: the transform from `%.100s` to `%.100s` on %s is ignored: %s\n",
                    parent != NULL ? parent : "", name != NULL ? name : "", topic, bad);
        tf->told = tf->told || bad != NULL;
    }
}

struct ros_placing tf_place(const struct tf *tf, bool in_odometry, const char *name, int64_t now_ns,
                            struct frames_pose *pose)
{
    struct ros_placing placing;
    const char *in = in_odometry ? tf->odometry : tf->robot;
    memset(&placing, 0, sizeof placing);
    snprintf(placing.in, sizeof placing.in, "%s", in);
    if (name == NULL || name[0] == '\0')
        name = in;
    snprintf(placing.frame, sizeof placing.frame, "%s", frames_name(name));
    if (frames_find(&tf->frames, in, name, now_ns, pose))
        placing.fate = ROS_FOUND;
    else
        placing.fate = tf->is_read ? ROS_NOT_FOUND : ROS_NOT_READ;
    return placing;
}
