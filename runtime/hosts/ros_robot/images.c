#include "images.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

#include <rcl/error_handling.h>
#include <rosidl_runtime_c/primitives_sequence_functions.h>
#include <rosidl_runtime_c/string_functions.h>

bool images_argument(struct images *images, const char *argument)
{
    struct image_topic *t = &images->each[images->count];
    char name[ROS_NAME - 8];
    void *memory;
    int file;
    if (images->count == ROS_CAMERAS_MOST ||
        sscanf(argument, "camera=%255[^,],%247[^,],%d", t->topic, name, &file) != 3)
        return false;
    memory = mmap(NULL, (size_t)ROS_IMAGE_SLOTS * ROS_IMAGE_MOST, PROT_READ, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED)
        return false;
    snprintf(t->frame, sizeof t->frame, "%s_link", name);
    t->memory = (const uint8_t *)memory;
    images->count++;
    return true;
}

const char *images_start(struct images *images, const rcl_node_t *node)
{
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    options.qos.depth = 2;
    if (!sensor_msgs__msg__Image__init(&images->message))
        return "images";
    for (size_t i = 0; i < images->count; i++) {
        struct image_topic *t = &images->each[i];
        t->publisher = rcl_get_zero_initialized_publisher();
        if (rcl_publisher_init(&t->publisher, node,
                               ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, Image), t->topic,
                               &options) != RCL_RET_OK)
            return t->topic;
    }
    return NULL;
}

void images_publish(struct images *images, const struct ros_image *image)
{
    sensor_msgs__msg__Image *m = &images->message;
    const size_t size = (size_t)image->width * image->height * image->channels;
    const struct image_topic *t;
    if (image->camera >= images->count || image->slot >= ROS_IMAGE_SLOTS || size > ROS_IMAGE_MOST)
        return;
    t = &images->each[image->camera];
    if (m->data.size != size) {
        rosidl_runtime_c__uint8__Sequence__fini(&m->data);
        if (!rosidl_runtime_c__uint8__Sequence__init(&m->data, size))
            return;
    }
    memcpy(m->data.data, t->memory + (size_t)image->slot * ROS_IMAGE_MOST, size);
    m->header.stamp.sec = (int32_t)(image->stamp_ns / 1000000000);
    m->header.stamp.nanosec = (uint32_t)(image->stamp_ns % 1000000000);
    m->width = image->width;
    m->height = image->height;
    m->step = image->width * image->channels;
    if (!rosidl_runtime_c__String__assign(&m->header.frame_id, t->frame) ||
        !rosidl_runtime_c__String__assign(&m->encoding, image->channels == 1 ? "mono8" : "rgb8") ||
        rcl_publish(&t->publisher, m, NULL) != RCL_RET_OK)
        rcl_reset_error();
}

bool images_end(struct images *images, rcl_node_t *node)
{
    bool ok = true;
    for (size_t i = 0; i < images->count; i++)
        ok = rcl_publisher_fini(&images->each[i].publisher, node) == RCL_RET_OK && ok;
    return ok;
}
