/* mapping.h -- message types, and how their members correspond to a program's values.
 *
 * The type support of ROS describes each message type: the names, types and offsets of its members.
 * The program's table describes its records in the same way, so no code is generated for a message
 * type. The node loads the libraries of the type's package when it starts. */
#ifndef FROB_HOST_ROS_MAPPING_H
#define FROB_HOST_ROS_MAPPING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <frob/program.h>

#include <rosidl_typesupport_introspection_c/message_introspection.h>

/* A message type. */
struct message_type {
    const char *name; /* "geometry_msgs/msg/Twist" */
    const rosidl_message_type_support_t *support;
    const rosidl_typesupport_introspection_c__MessageMembers *members;
};

/* Looks up a type by name in the packages of the sourced ROS 2 installation. If there is no such
 * type, returns false and explains why in `why`. */
bool message_type_find(struct message_type *type, const char *name, char *why, size_t room);

/* Allocates an initialized message; NULL if there is not enough memory. */
void *message_create(const struct message_type *type);

/* Returns the header of the message if that is its first member, else NULL. */
void *message_header(const struct message_type *type, void *message);

/* The correspondence between a value of the program and a part of a message. */
struct mapping {
    enum { MAPPING_NUMBER, MAPPING_TEXT, MAPPING_RECORD, MAPPING_ARRAY, MAPPING_SEQUENCE } kind;
    /* The member that contains the value; NULL if the value is the whole message. */
    const rosidl_typesupport_introspection_c__MessageMember *member;
    const struct frob_value *value;    /* for a number or string */
    const struct frob_texts *texts;    /* for a string: the strings of its enumeration */
    const struct frob_value *optional; /* for a string: the Maybe that contains it, or NULL */
    const struct frob_value *count;    /* for a variable-length sequence: its count */
    struct mapping *parts;             /* the fields of a record, or the elements */
    size_t part_count;
    /* The header of a record (NULL if the record has none), and whether to set the parts of the
     * header that the program omits. */
    const rosidl_typesupport_introspection_c__MessageMember *header;
    bool sets_stamp, sets_frame;
};

/* Maps a value of the program to messages of a type. `node` contains the strings of enumerations.
 * If the value does not match the type, returns false and explains the mismatch in `why`. */
bool mapping_of(struct mapping *mapping, const struct message_type *type,
                const struct frob_value *value, const struct frob_node *node, char *why,
                size_t room);

#endif
