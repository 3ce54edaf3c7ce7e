/* topics.h -- the topics of a node's own as parts of the program's input and output structs. */
#ifndef FROB_HOST_ROS_TOPICS_H
#define FROB_HOST_ROS_TOPICS_H

#include <frob/program.h>

/* The value of a topic, and its parts. */
struct topic_parts {
    const struct frob_value *whole;
    const struct frob_value *event;   /* NULL: a plain value */
    const struct frob_value *missed;  /* of a Counted; NULL: none */
    const struct frob_value *message; /* NULL: an event without a value */
};

/* `record`: the program's input or output. */
struct topic_parts topic_parts_of(const struct frob_value *record, const struct frob_topic *topic);

/* The bytes of a value in its struct: from `first` up to `end`, exclusively. */
struct topic_span {
    size_t first, end;
};

/* The span is empty for a value without bytes. */
struct topic_span topic_span_of(const struct frob_value *value);

#endif
