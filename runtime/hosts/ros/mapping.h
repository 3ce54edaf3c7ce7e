/* mapping.h -- types of messages, and how their members correspond to values of a program.
 *
 * The type support of ROS describes each type of messages: the names, types and places of its
 * members. The program's table describes its records in the same way. Therefore no code is
 * generated for a type. The node loads the libraries of the type's package when it starts. */
#ifndef FROB_HOST_ROS_MAPPING_H
#define FROB_HOST_ROS_MAPPING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <frob/program.h>

#include <rosidl_typesupport_introspection_c/message_introspection.h>

/* A type of messages. */
struct message_type {
    const char *name; /* "geometry_msgs/msg/Twist" */
    const rosidl_message_type_support_t *support;
    const rosidl_typesupport_introspection_c__MessageMembers *members;
};

/* Finds a type by its name, in the packages of the sourced ROS 2. If it does not exist, returns
 * false and explains it in `why`. */
bool message_type_find(struct message_type *type, const char *name, char *why, size_t room);

/* Allocates an initialized message; NULL if there is not enough memory. */
void *message_create(const struct message_type *type);

/* Returns the header of the message if that is its first member, else NULL. */
void *message_header(const struct message_type *type, void *message);

/* How a value of the program corresponds to a part of a message. */
struct mapping {
    enum { MAPPING_NUMBER, MAPPING_TEXT, MAPPING_RECORD, MAPPING_ARRAY, MAPPING_SEQUENCE } kind;
    /* The member that contains the value; NULL if the value is the whole message. */
    const rosidl_typesupport_introspection_c__MessageMember *member;
    const struct frob_value *value;    /* for a number or text */
    const struct frob_texts *texts;    /* for a text: the texts of its enumeration */
    const struct frob_value *optional; /* for a text: the Maybe that contains it, or NULL */
    const struct frob_value *count;    /* for a sequence with a variable length: its count */
    struct mapping *parts;             /* the fields of a record, or the elements */
    size_t part_count;
    /* The header of a record (NULL if it has none), and whether the program omits parts of it. */
    const rosidl_typesupport_introspection_c__MessageMember *header;
    bool sets_stamp, sets_frame;
};

/* Maps a value of the program to messages of a type. `node` contains the texts of enumerations. If
 * they do not correspond, returns false and explains it in `why`. */
bool mapping_of(struct mapping *mapping, const struct message_type *type,
                const struct frob_value *value, const struct frob_node *node, char *why,
                size_t room);

#endif
