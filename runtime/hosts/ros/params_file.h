/* params_file.h -- the values of parameters in a ROS parameter file (YAML), as launch files pass
 * them. */
#ifndef FROB_HOST_ROS_PARAMS_FILE_H
#define FROB_HOST_ROS_PARAMS_FILE_H

#include <stdbool.h>

/* Calls `set` for each value that the file contains for this node, in file order. Values are passed
 * as text, as in `-p NAME:=VALUE`. `node`: the node's full name. Returns false if the file cannot
 * be read; rcl then reports why. */
bool params_file_read(const char *file, const char *node,
                      void (*set)(void *context, const char *name, const char *value),
                      void *context);

/* Returns whether a node name in a parameter file matches this node. The name can be the node's
 * name, with or without the leading slash, or a pattern in which `*` matches one part of a name and
 * `**` any number of parts. */
bool params_file_matches(const char *pattern, const char *node);

#endif
