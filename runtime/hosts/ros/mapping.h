/* mapping.h -- types of messages, and how their members correspond to values of a program.
 *
 * The type support of ROS describes each type of messages: the names, types and places of its
 * members. The program's table describes its records in the same way. So no code is generated for a
 * type; libraries of its package are loaded when the node starts. */
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

/* Finds a type by its name, in the packages of this ROS 2. Returns false if it does not exist; then
 * `why` explains it. */
bool message_type_find(struct message_type *type, const char *name, char *why, size_t room);

/* Allocates an initialized message; NULL if there is not enough memory. */
void *message_create(const struct message_type *type);

/* Returns the header of the message if that is its first member, else NULL. */
void *message_header(const struct message_type *type, void *message);

/* How a value of the program and a part of a message correspond. */
struct mapping {
    enum { MAPPING_NUMBER, MAPPING_TEXT, MAPPING_RECORD, MAPPING_ARRAY, MAPPING_SEQUENCE } kind;
    const rosidl_typesupport_introspection_c__MessageMember *member; /* NULL: the whole message */
    const struct frob_value *value;                                  /* of a number or text */
    const struct frob_texts *texts;                                  /* of a text */
    const struct frob_value *optional; /* the Maybe that contains the text; NULL: none */
    const struct frob_value *count;    /* of a sequence with a variable length */
    struct mapping *parts;             /* of a record, or elements */
    size_t part_count;
    /* The header of a record, NULL if it has none, and whether the program leaves out its parts. */
    const rosidl_typesupport_introspection_c__MessageMember *header;
    bool sets_stamp, sets_frame;
};

/* Maps a value of the program to messages of a type. `node` has the texts. Returns false if they do
 * not correspond; then `why` explains it. */
bool mapping_of(struct mapping *mapping, const struct message_type *type,
                const struct frob_value *value, const struct frob_node *node, char *why,
                size_t room);

#endif
