#include "topics.h"

#include <stdbool.h>
#include <string.h>

/* Returns the value of the record's field with this name. The record has a field for each topic. */
static const struct frob_value *field_of(const struct frob_value *record, const char *name)
{
    const struct frob_constructor *only = &record->constructors[0];
    size_t k = 0;
    while (k + 1 < only->count && strcmp(only->fields[k].name, name) != 0)
        k++;
    return only->fields[k].value;
}

struct topic_parts topic_parts_of(const struct frob_value *record, const struct frob_topic *topic)
{
    struct topic_parts parts = { field_of(record, topic->field), NULL, NULL, NULL };
    parts.message = parts.whole;
    if (parts.whole->is_event) {
        const struct frob_constructor *event = &parts.whole->constructors[1];
        parts.event = parts.whole;
        parts.message = event->count > 0 ? event->fields[0].value : NULL;
    }
    if (parts.message != NULL && topic->is_counted) {
        parts.missed = parts.message->constructors[0].fields[1].value;
        parts.message = parts.message->constructors[0].fields[0].value;
    }
    return parts;
}

static size_t size_of(enum frob_kind kind)
{
    switch (kind) {
    case FROB_BOOL: return sizeof(bool);
    case FROB_INT: return sizeof(int32_t);
    case FROB_FLOAT:
    case FROB_ROUNDED: return sizeof(double);
    case FROB_SINGLE: return sizeof(float);
    case FROB_SUM: return 1; /* the tag */
    case FROB_IMAGE: return sizeof(void *);
    case FROB_PRODUCT:
    case FROB_ARRAY: break;
    }
    return 0;
}

static void include(struct topic_span *span, const struct frob_value *value)
{
    const size_t size = size_of(value->kind);
    if (size > 0 && value->offset < span->first)
        span->first = value->offset;
    if (size > 0 && value->offset + size > span->end)
        span->end = value->offset + size;
    for (size_t c = 0; c < value->count; c++)
        for (size_t f = 0; f < value->constructors[c].count; f++)
            include(span, value->constructors[c].fields[f].value);
}

struct topic_span topic_span_of(const struct frob_value *value)
{
    struct topic_span span = { SIZE_MAX, 0 };
    include(&span, value);
    if (span.end == 0)
        span.first = 0;
    return span;
}
