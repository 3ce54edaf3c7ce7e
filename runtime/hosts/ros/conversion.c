#include "conversion.h"

#include <math.h>
#include <string.h>

#include <rosidl_runtime_c/string_functions.h>
#include <rosidl_typesupport_introspection_c/field_types.h>
#include <std_msgs/msg/header.h>

#define TYPE(name) rosidl_typesupport_introspection_c__ROS_TYPE_##name

/* ---- Numbers */

static int64_t whole_at(const void *place, uint8_t type)
{
    union {
        uint8_t u8;
        int8_t i8;
        uint16_t u16;
        int16_t i16;
        uint32_t u32;
        int32_t i32;
        uint64_t u64;
        int64_t i64;
    } x;
    switch (type) {
    case TYPE(INT8): return memcpy(&x, place, 1), x.i8;
    case TYPE(UINT16): return memcpy(&x, place, 2), x.u16;
    case TYPE(INT16): return memcpy(&x, place, 2), x.i16;
    case TYPE(UINT32): return memcpy(&x, place, 4), x.u32;
    case TYPE(INT32): return memcpy(&x, place, 4), x.i32;
    case TYPE(UINT64): return memcpy(&x, place, 8), x.u64 > INT64_MAX ? INT64_MAX : (int64_t)x.u64;
    case TYPE(INT64): return memcpy(&x, place, 8), x.i64;
    default: return memcpy(&x, place, 1), x.u8;
    }
}

static int64_t clamped(int64_t x, int64_t least, int64_t most)
{
    return x < least ? least : x > most ? most : x;
}

static void set_whole(void *place, uint8_t type, int32_t x)
{
    const uint8_t u8 = (uint8_t)clamped(x, 0, UINT8_MAX);
    const int8_t i8 = (int8_t)clamped(x, INT8_MIN, INT8_MAX);
    const uint16_t u16 = (uint16_t)clamped(x, 0, UINT16_MAX);
    const int16_t i16 = (int16_t)clamped(x, INT16_MIN, INT16_MAX);
    const uint32_t u32 = (uint32_t)clamped(x, 0, INT32_MAX);
    const uint64_t u64 = (uint64_t)u32;
    const int64_t i64 = x;
    switch (type) {
    case TYPE(INT8): memcpy(place, &i8, 1); break;
    case TYPE(UINT16): memcpy(place, &u16, 2); break;
    case TYPE(INT16): memcpy(place, &i16, 2); break;
    case TYPE(UINT32): memcpy(place, &u32, 4); break;
    case TYPE(INT32): memcpy(place, &x, 4); break;
    case TYPE(UINT64): memcpy(place, &u64, 8); break;
    case TYPE(INT64): memcpy(place, &i64, 8); break;
    default: memcpy(place, &u8, 1); break;
    }
}

static double float_of(const struct frob_value *value, const void *values)
{
    const char *place = (const char *)values + value->offset;
    double x;
    float single;
    if (value->kind == FROB_SINGLE)
        return memcpy(&single, place, sizeof single), (double)single;
    return memcpy(&x, place, sizeof x), x;
}

static void read_number(const struct mapping *m, const void *from, void *values)
{
    char *to = (char *)values + m->value->offset;
    double x;
    float single;
    int32_t whole;
    bool truth;
    switch (m->value->kind) {
    case FROB_BOOL:
        memcpy(&truth, from, sizeof truth);
        memcpy(to, &truth, sizeof truth);
        return;
    case FROB_INT:
        whole = (int32_t)clamped(whole_at(from, m->member->type_id_), INT32_MIN, INT32_MAX);
        memcpy(to, &whole, sizeof whole);
        return;
    default: break;
    }
    if (m->member->type_id_ == TYPE(FLOAT))
        x = (double)(memcpy(&single, from, sizeof single), single);
    else
        memcpy(&x, from, sizeof x);
    single = (float)x;
    if (m->value->kind == FROB_ROUNDED)
        x = (double)single;
    if (m->value->kind == FROB_SINGLE)
        memcpy(to, &single, sizeof single);
    else
        memcpy(to, &x, sizeof x);
}

static void write_number(const struct mapping *m, const void *values, void *to)
{
    const char *from = (const char *)values + m->value->offset;
    double x;
    float single;
    int32_t whole;
    switch (m->value->kind) {
    case FROB_BOOL: memcpy(to, from, sizeof(bool)); return;
    case FROB_INT:
        memcpy(&whole, from, sizeof whole);
        set_whole(to, m->member->type_id_, whole);
        return;
    default: break;
    }
    x = float_of(m->value, values);
    single = (float)x;
    if (m->member->type_id_ == TYPE(FLOAT))
        memcpy(to, &single, sizeof single);
    else
        memcpy(to, &x, sizeof x);
}

/* ---- Texts */

static void set_tag(const struct frob_value *value, size_t tag, void *values)
{
    const uint8_t byte = (uint8_t)tag;
    /* A product type has one constructor and no tag. */
    if (value->kind == FROB_SUM)
        memcpy((char *)values + value->offset, &byte, sizeof byte);
}

static size_t tag_of(const struct frob_value *value, const void *values)
{
    uint8_t byte = 0;
    if (value->kind == FROB_SUM)
        memcpy(&byte, (const char *)values + value->offset, sizeof byte);
    return byte;
}

static bool read_text(const struct mapping *m, const void *place, void *values,
                      struct mapping_fault *fault)
{
    const char *text = ((const rosidl_runtime_c__String *)place)->data;
    size_t k = 0;
    text = text == NULL ? "" : text;
    while (k < m->value->count && strcmp(m->texts->texts[k], text) != 0)
        k++;
    if (k < m->value->count)
        set_tag(m->value, k, values);
    if (m->optional != NULL)
        set_tag(m->optional, k < m->value->count ? 1 : 0, values);
    /* `Nothing` is published as an empty string, so an empty string is not a fault in a `Maybe`. */
    if (k == m->value->count && (m->optional == NULL || *text != '\0')) {
        fault->text = text;
        fault->of = m;
    }
    return k < m->value->count || m->optional != NULL;
}

static bool assign(rosidl_runtime_c__String *string, const char *text)
{
    return (string->data != NULL && strcmp(string->data, text) == 0) ||
           rosidl_runtime_c__String__assign(string, text);
}

static bool write_text(const struct mapping *m, const void *values, void *place)
{
    const bool is_nothing = m->optional != NULL && tag_of(m->optional, values) == 0;
    return assign((rosidl_runtime_c__String *)place,
                  is_nothing ? "" : m->texts->texts[tag_of(m->value, values)]);
}

/* ---- Values. `place` is the address of the record, number or element in the message. */

static bool read_at(const struct mapping *m, const void *place, void *values,
                    struct mapping_fault *fault);

static const void *member_in(const struct mapping *m, const void *record)
{
    return (const char *)record + m->member->offset_;
}

/* Elements after the end of a sequence keep their previous values. */
static bool read_elements(const struct mapping *m, const void *sequence, void *values,
                          struct mapping_fault *fault)
{
    const size_t size = m->member->size_function(sequence);
    const size_t count = size < m->part_count ? size : m->part_count;
    const int32_t number = (int32_t)count;
    bool ok = m->kind == MAPPING_SEQUENCE || size == m->part_count;
    if (m->kind == MAPPING_SEQUENCE)
        memcpy((char *)values + m->count->offset, &number, sizeof number);
    if (!ok) {
        fault->text = NULL;
        fault->of = m;
    }
    for (size_t k = 0; ok && k < count; k++)
        ok = read_at(&m->parts[k], m->member->get_const_function(sequence, k), values, fault);
    return ok;
}

static bool read_at(const struct mapping *m, const void *place, void *values,
                    struct mapping_fault *fault)
{
    bool ok = true;
    if (m->kind == MAPPING_NUMBER)
        read_number(m, place, values);
    else if (m->kind == MAPPING_TEXT)
        return read_text(m, place, values, fault);
    else if (m->kind != MAPPING_RECORD)
        return read_elements(m, place, values, fault);
    else
        for (size_t k = 0; ok && k < m->part_count; k++)
            ok = read_at(&m->parts[k], member_in(&m->parts[k], place), values, fault);
    return ok;
}

bool mapping_read(const struct mapping *m, const void *message, void *values,
                  struct mapping_fault *fault)
{
    fault->of = NULL;
    return read_at(m, message, values, fault);
}

static size_t count_in(const struct mapping *m, const void *values)
{
    int32_t count;
    if (m->kind == MAPPING_ARRAY)
        return m->part_count;
    memcpy(&count, (const char *)values + m->count->offset, sizeof count);
    return (size_t)clamped(count, 0, (int64_t)m->part_count);
}

static bool write_header(const struct mapping *m, const struct message_origin *origin, void *record)
{
    std_msgs__msg__Header *header =
        (std_msgs__msg__Header *)(void *)((char *)record + m->header->offset_);
    if (m->sets_stamp) {
        header->stamp.sec = (int32_t)(origin->stamp_ns / 1000000000);
        header->stamp.nanosec = (uint32_t)(origin->stamp_ns % 1000000000);
    }
    return !m->sets_frame || assign(&header->frame_id, origin->frame);
}

static bool write_at(const struct mapping *m, const void *values,
                     const struct message_origin *origin, void *place)
{
    size_t count;
    if (m->kind == MAPPING_TEXT)
        return write_text(m, values, place);
    if (m->kind == MAPPING_NUMBER) {
        write_number(m, values, place);
        return true;
    }
    if (m->kind == MAPPING_RECORD) {
        for (size_t k = 0; k < m->part_count; k++)
            if (!write_at(&m->parts[k], values, origin,
                          (char *)place + m->parts[k].member->offset_))
                return false;
        return m->header == NULL || write_header(m, origin, place);
    }
    count = count_in(m, values);
    if (m->member->resize_function != NULL && m->member->size_function(place) != count &&
        !m->member->resize_function(place, count))
        return false;
    for (size_t k = 0; k < count; k++)
        if (!write_at(&m->parts[k], values, origin, m->member->get_function(place, k)))
            return false;
    return true;
}

bool mapping_write(const struct mapping *m, const void *values, const struct message_origin *origin,
                   void *message)
{
    return write_at(m, values, origin, message);
}

bool mapping_is_finite(const struct mapping *m, const void *values)
{
    const size_t count = m->kind == MAPPING_SEQUENCE ? count_in(m, values) : m->part_count;
    if (m->kind == MAPPING_TEXT)
        return true;
    if (m->kind == MAPPING_NUMBER)
        return m->value->kind == FROB_BOOL || m->value->kind == FROB_INT ||
               isfinite(float_of(m->value, values));
    for (size_t k = 0; k < count; k++)
        if (!mapping_is_finite(&m->parts[k], values))
            return false;
    return true;
}
