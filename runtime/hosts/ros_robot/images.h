/* images.h -- publishes the images of the simulated robot's cameras.
 *
 * An image is too large for a message on the socket. The simulator writes it to memory that it
 * shares with this process. There are ROS_IMAGE_SLOTS slots for each camera, and the message
 * contains the slot's number. */
#ifndef FROB_HOST_ROS_ROBOT_IMAGES_H
#define FROB_HOST_ROS_ROBOT_IMAGES_H

#include <rcl/rcl.h>
#include <sensor_msgs/msg/image.h>

#include <stdbool.h>
#include <stddef.h>

#include "hosts/ros/messages.h"

struct image_topic {
    char topic[ROS_NAME], frame[ROS_NAME];
    const uint8_t *memory;
    rcl_publisher_t publisher;
};

struct images {
    struct image_topic each[ROS_CAMERAS_MOST];
    size_t count;
    sensor_msgs__msg__Image message;
};

/* Reads the argument `camera=TOPIC,NAME,DESCRIPTOR`. Returns false for other arguments. */
bool images_argument(struct images *images, const char *argument);

/* Returns NULL, or the name of a topic that rcl rejects. */
const char *images_start(struct images *images, const rcl_node_t *node);

void images_publish(struct images *images, const struct ros_image *image);

/* Returns false if rcl reports an error. */
bool images_end(struct images *images, rcl_node_t *node);

#endif
