/* params_file.h -- the values of parameters in a ROS parameter file (YAML), as launch files pass
 * them. */
#ifndef FROB_HOST_ROS_PARAMS_FILE_H
#define FROB_HOST_ROS_PARAMS_FILE_H

#include <stdbool.h>

/* Calls `set` for each value in the file for this node: in the order of the file, with the value
 * as text, as in `-p NAME:=VALUE`. `node`: its full name. Returns false if the file cannot be read;
 * rcl then reports why. */
bool params_file_read(const char *file, const char *node,
                      void (*set)(void *context, const char *name, const char *value),
                      void *context);

/* Returns whether the name of a node in such a file matches this node. It matches if it is the
 * node's name, with or without the first slash, or a pattern in which `*` matches one part of a
 * name and `**` any number of parts. */
bool params_file_matches(const char *pattern, const char *node);

#endif
