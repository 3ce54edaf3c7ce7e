#include "frames.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A transform from /tf that is older than this is ignored. */
#define VALID_NS INT64_C(2000000000)

/* Maximum difference between 1 and the squared norm of a quaternion. */
#define ROUGHLY 0.02

/* Cosine of the largest tilt (0.2 rad) at which a lidar's scans count as parallel to the floor. */
static const double level = 0.98;

/* ---- Poses */

/* Rotates a vector: v + 2 w (q x v) + 2 q x (q x v). */
void frames_rotate(const double q[4], const double v[3], double result[3])
{
    const double s[3] = { 2.0 * (q[1] * v[2] - q[2] * v[1]), 2.0 * (q[2] * v[0] - q[0] * v[2]),
                          2.0 * (q[0] * v[1] - q[1] * v[0]) };
    result[0] = v[0] + q[3] * s[0] + q[1] * s[2] - q[2] * s[1];
    result[1] = v[1] + q[3] * s[1] + q[2] * s[0] - q[0] * s[2];
    result[2] = v[2] + q[3] * s[2] + q[0] * s[1] - q[1] * s[0];
}

void frames_point(const struct frames_pose *pose, const double point[3], double result[3])
{
    frames_rotate(pose->rotation, point, result);
    for (size_t i = 0; i < 3; i++)
        result[i] += pose->at_m[i];
}

static void multiply(const double p[4], const double q[4], double result[4])
{
    result[0] = p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1];
    result[1] = p[3] * q[1] + p[1] * q[3] + p[2] * q[0] - p[0] * q[2];
    result[2] = p[3] * q[2] + p[2] * q[3] + p[0] * q[1] - p[1] * q[0];
    result[3] = p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2];
}

void frames_orientation(const double device[4], const double mounting[4], double result[4])
{
    const double back[4] = { -mounting[0], -mounting[1], -mounting[2], mounting[3] };
    multiply(device, back, result);
}

/* Returns the pose of C in A, given the poses of B in A and of C in B. */
static struct frames_pose combined(const struct frames_pose *outer, const struct frames_pose *inner)
{
    struct frames_pose result;
    frames_point(outer, inner->at_m, result.at_m);
    multiply(outer->rotation, inner->rotation, result.rotation);
    return result;
}

static struct frames_pose inverse(const struct frames_pose *pose)
{
    const double *q = pose->rotation;
    struct frames_pose result = { { 0.0, 0.0, 0.0 }, { -q[0], -q[1], -q[2], q[3] } };
    frames_rotate(result.rotation, pose->at_m, result.at_m);
    for (size_t i = 0; i < 3; i++)
        result.at_m[i] = -result.at_m[i];
    return result;
}

static const struct frames_pose identity = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 1.0 } };

/* ---- The tree */

const char *frames_name(const char *name)
{
    return name[0] == '/' ? name + 1 : name;
}

static const struct frame *find(const struct frames *frames, const char *name)
{
    for (size_t i = 0; i < frames->count; i++)
        if (strcmp(frames->each[i].name, name) == 0)
            return &frames->each[i];
    return NULL;
}

const char *frames_put(struct frames *frames, const char *parent, const char *name,
                       const struct frames_pose *pose, bool is_fixed, int64_t now_ns)
{
    const double *q = pose->rotation;
    struct frame *frame;
    double norm = 0.0;
    parent = frames_name(parent);
    name = frames_name(name);
    if (name[0] == '\0' || parent[0] == '\0' || strcmp(name, parent) == 0)
        return "it does not name two different frames";
    if (strlen(name) >= ROS_FRAME || strlen(parent) >= ROS_FRAME)
        return "the name of a frame is too long";
    for (size_t i = 0; i < 3; i++)
        if (!isfinite(pose->at_m[i]))
            return "a position is not a finite number";
    for (size_t i = 0; i < 4; i++)
        norm += q[i] * q[i];
    if (!(fabs(norm - 1.0) <= ROUGHLY))
        return "a rotation is not a quaternion of length 1";
    frame = (struct frame *)(uintptr_t)find(frames, name);
    if (frame == NULL && frames->count == FRAMES_MOST)
        return "there are more than 256 frames";
    if (frame == NULL)
        frame = &frames->each[frames->count++];
    memset(frame, 0, sizeof *frame);
    snprintf(frame->name, sizeof frame->name, "%s", name);
    snprintf(frame->parent, sizeof frame->parent, "%s", parent);
    frame->is_fixed = is_fixed;
    frame->arrived_ns = now_ns;
    frame->pose = *pose;
    for (size_t i = 0; i < 4; i++)
        frame->pose.rotation[i] /= sqrt(norm);
    return NULL;
}

/* Replaces a frame with its parent, and converts a pose from the frame to the parent. Returns
 * false at the root. */
static bool climb(const struct frames *frames, const char **name, struct frames_pose *pose,
                  int64_t now_ns)
{
    const struct frame *frame = find(frames, *name);
    if (frame == NULL || (!frame->is_fixed && now_ns - frame->arrived_ns > VALID_NS))
        return false;
    *pose = combined(&frame->pose, pose);
    *name = frame->parent;
    return true;
}

/* Finds the pose of a frame relative to one of its ancestors or to itself. */
static bool find_in_ancestor(const struct frames *frames, const char *ancestor, const char *name,
                             int64_t now_ns, struct frames_pose *pose)
{
    *pose = identity;
    /* The limit ends the search if the frames form a loop. */
    for (size_t i = 0; i <= FRAMES_MOST; i++) {
        if (strcmp(name, ancestor) == 0)
            return true;
        if (!climb(frames, &name, pose, now_ns))
            return false;
    }
    return false;
}

bool frames_find(const struct frames *frames, const char *in, const char *name, int64_t now_ns,
                 struct frames_pose *pose)
{
    struct frames_pose own = identity, others;
    in = frames_name(in);
    name = frames_name(name);
    for (size_t i = 0; i <= FRAMES_MOST; i++) {
        if (find_in_ancestor(frames, name, in, now_ns, &others)) {
            const struct frames_pose back = inverse(&others);
            *pose = combined(&back, &own);
            return true;
        }
        if (!climb(frames, &name, &own, now_ns))
            return false;
    }
    return false;
}

/* ---- Lidars */

bool frames_seat(const struct frames_pose *pose, struct ros_seat *seat)
{
    static const double ahead[3] = { 1.0, 0.0, 0.0 }, up[3] = { 0.0, 0.0, 1.0 };
    double its_ahead[3], its_up[3];
    frames_rotate(pose->rotation, ahead, its_ahead);
    frames_rotate(pose->rotation, up, its_up);
    seat->x_m = pose->at_m[0];
    seat->y_m = pose->at_m[1];
    seat->heading_rad = atan2(its_ahead[1], its_ahead[0]);
    seat->is_upside_down = its_up[2] < 0.0;
    return fabs(its_up[2]) >= level;
}
