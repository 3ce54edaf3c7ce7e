/* late.h -- ROS libraries that the node loads only if the program needs them, because each takes
 * memory in the node's process. */
#ifndef FROB_HOST_ROS_LATE_H
#define FROB_HOST_ROS_LATE_H

#include <stdbool.h>
#include <stddef.h>

#include <rcl/rcl.h>

/* Loads a library, such as "rcl_lifecycle", from the prefixes of this ROS 2 installation. Returns
 * NULL if it does not exist. */
void *late_library(const char *name);

/* Loads the libraries of a package: the functions for its messages, and the type support. Returns
 * false if they do not exist; then `why` contains the reason. */
bool late_messages(const char *package, char *why, size_t room);

/* Returns a function of a library; NULL if it does not exist. */
typedef void late_function(void);
late_function *late_find(const char *library, const char *name);

/* A function of a library, cast to the type that the library's header declares. */
#define LATE(library, function) ((__typeof__(&function))late_find(library, #function))

/* These return the type support of a message or service; NULL if it does not exist. */
const rosidl_message_type_support_t *late_message_type(const char *package, const char *name);
const rosidl_service_type_support_t *late_service_type(const char *package, const char *name);

#endif
