/* topics.h -- finds the program's own topics in its input and output structs. */
#ifndef FROB_HOST_ROS_TOPICS_H
#define FROB_HOST_ROS_TOPICS_H

#include <frob/program.h>

/* The value of a topic, and its parts. */
struct topic_parts {
    const struct frob_value *whole;
    const struct frob_value *event;   /* NULL for a plain value */
    const struct frob_value *missed;  /* the count in a Counted; NULL if there is none */
    const struct frob_value *message; /* the value of an event; NULL if the event has none */
};

/* `record`: the program's input or output. */
struct topic_parts topic_parts_of(const struct frob_value *record, const struct frob_topic *topic);

/* The bytes of a value in its struct: from `first` up to but not including `end`. */
struct topic_span {
    size_t first, end;
};

/* The span is empty for a value without bytes. */
struct topic_span topic_span_of(const struct frob_value *value);

#endif
