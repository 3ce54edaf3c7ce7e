/* conversion.h -- converts messages of any type to values of a program and back. */
#ifndef FROB_HOST_ROS_CONVERSION_H
#define FROB_HOST_ROS_CONVERSION_H

#include "mapping.h"

/* The part of a message that does not match the program's type. */
struct mapping_fault {
    const struct mapping *of; /* NULL if there is none */
    const char *text;         /* an unknown string; NULL if an array has the wrong length */
};

/* Copies a message to the mapped value in `values`, a struct of the program. Returns false if the
 * message cannot be used. Reports an unknown string even if it becomes Nothing. */
bool mapping_read(const struct mapping *mapping, const void *message, void *values,
                  struct mapping_fault *fault);

/* The values that the node writes to a header if the program does not set them. */
struct message_origin {
    int64_t stamp_ns;
    const char *frame;
};

/* Copies the value to a message. Returns false if memory runs out. */
bool mapping_write(const struct mapping *mapping, const void *values,
                   const struct message_origin *origin, void *message);

/* Returns whether all numbers of the value are finite. */
bool mapping_is_finite(const struct mapping *mapping, const void *values);

#endif
