#include "conversion.h"

#include <ctype.h>
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <rosidl_runtime_c/string_functions.h>
#include <rosidl_typesupport_introspection_c/field_types.h>
#include <std_msgs/msg/header.h>

#define TYPE(name) rosidl_typesupport_introspection_c__ROS_TYPE_##name

typedef rosidl_typesupport_introspection_c__MessageMember member_type;
typedef rosidl_typesupport_introspection_c__MessageMembers members_type;

static const char introspection[] = "rosidl_typesupport_introspection_c";

/* ---- Types of messages */

/* Loads the type support of a package from the prefixes of this ROS 2. */
static void *load(const char *package)
{
    const char *prefixes = getenv("AMENT_PREFIX_PATH"), *prefix = prefixes;
    char path[1024];
    void *library;
    while (prefix != NULL && *prefix != '\0') {
        const size_t length = strcspn(prefix, ":");
        snprintf(path, sizeof path, "%.*s/lib/lib%s__rosidl_typesupport_c.so", (int)length, prefix,
                 package);
        library = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
        if (library != NULL)
            return library;
        prefix += length + (prefix[length] == ':' ? 1 : 0);
    }
    snprintf(path, sizeof path, "lib%s__rosidl_typesupport_c.so", package);
    return dlopen(path, RTLD_NOW | RTLD_GLOBAL);
}

static const members_type *members_of(const rosidl_message_type_support_t *support)
{
    const rosidl_message_type_support_t *found =
        support == NULL ? NULL : support->func(support, introspection);
    return found == NULL ? NULL : (const members_type *)found->data;
}

bool message_type_find(struct message_type *type, const char *name, char *why, size_t room)
{
    char package[128], symbol[400];
    const char *last = strrchr(name, '/');
    const rosidl_message_type_support_t *(*handle)(void) = NULL;
    void *library;
    memset(type, 0, sizeof *type);
    type->name = name;
    snprintf(package, sizeof package, "%.*s", (int)strcspn(name, "/"), name);
    library = load(package);
    if (library == NULL) {
        snprintf(why, room, "this ROS 2 has no messages of the package %s: install it", package);
        return false;
    }
    snprintf(symbol, sizeof symbol,
             "rosidl_typesupport_c__get_message_type_support_handle__%s__msg__%s", package,
             last + 1);
    *(void **)&handle = dlsym(library, symbol);
    if (handle != NULL)
        type->support = handle();
    type->members = members_of(type->support);
    if (type->members == NULL)
        snprintf(why, room, "the package %s of this ROS 2 has no message %s", package, last + 1);
    return type->members != NULL;
}

void *message_create(const struct message_type *type)
{
    void *message = calloc(1, type->members->size_of_ + 1);
    if (message != NULL)
        type->members->init_function(message, ROSIDL_RUNTIME_C_MSG_INIT_ALL);
    return message;
}

/* Returns whether the first member of the record is a header. */
static bool has_header(const members_type *record)
{
    const member_type *first = record->members_;
    const members_type *members;
    if (record->member_count_ == 0 || first->type_id_ != TYPE(MESSAGE) || first->is_array_)
        return false;
    members = members_of(first->members_);
    return members != NULL && strcmp(members->message_name_, "Header") == 0 &&
           strcmp(members->message_namespace_, "std_msgs__msg") == 0;
}

void *message_header(const struct message_type *type, void *message)
{
    return has_header(type->members) ? (char *)message + type->members->members_[0].offset_ : NULL;
}

/* ---- Names */

/* Returns whether a field of a record has the name of the member: angleMin is angle_min, and data_
 * is data. */
static bool is_named(const char *field, const char *member)
{
    for (; *member != '\0'; member++) {
        bool is_capital = false;
        for (; *member == '_'; member++)
            is_capital = true;
        if (*member == '\0')
            break;
        if (*field++ != (is_capital ? toupper((unsigned char)*member) : *member))
            return false;
    }
    return *field == '\0' || strcmp(field, "_") == 0;
}

static const member_type *member_named(const members_type *members, const char *field)
{
    for (uint32_t i = 0; i < members->member_count_; i++)
        if (is_named(field, members->members_[i].name_))
            return &members->members_[i];
    return NULL;
}

static const char *type_text(uint8_t type)
{
    switch (type) {
    case TYPE(FLOAT): return "float32";
    case TYPE(DOUBLE): return "float64";
    case TYPE(CHAR): return "char";
    case TYPE(BOOLEAN): return "bool";
    case TYPE(OCTET): return "byte";
    case TYPE(UINT8): return "uint8";
    case TYPE(INT8): return "int8";
    case TYPE(UINT16): return "uint16";
    case TYPE(INT16): return "int16";
    case TYPE(UINT32): return "uint32";
    case TYPE(INT32): return "int32";
    case TYPE(UINT64): return "uint64";
    case TYPE(INT64): return "int64";
    case TYPE(MESSAGE): return "a message";
    default: return "a text";
    }
}

/* ---- Mappings */

struct search {
    char *why;
    size_t room;
    const char *type;   /* of the whole message */
    const char *record; /* of the program that contains the value; NULL: it is the whole message */
    const struct frob_node *node;
};

/* What to write for a member in the program. */
static const char *wanted(const member_type *member)
{
    switch (member->type_id_) {
    case TYPE(BOOLEAN): return "Bool";
    case TYPE(FLOAT):
    case TYPE(DOUBLE): return "Float";
    case TYPE(MESSAGE): return "a record";
    case TYPE(STRING): return "an enumeration with an instance of `RosText`";
    case TYPE(WSTRING): return NULL;
    default: return "Int";
    }
}

static bool refuse(const struct search *s, const member_type *member, const char *what)
{
    const char *type = wanted(member);
    const char *several = !member->is_array_                                    ? ""
                          : member->array_size_ == 0 || member->is_upper_bound_ ? "`Upto` of "
                                                                                : "`Array` of ";
    snprintf(s->why, s->room, "in %s, `%s` is %s%s, but in the record `%s` it is %s: %s%s%s",
             s->type, member->name_, type_text(member->type_id_),
             member->is_array_ ? " (several)" : "", s->record == NULL ? "" : s->record, what,
             type == NULL ? "leave the field out" : "declare it as ", type == NULL ? "" : several,
             type == NULL ? "" : type);
    return false;
}

static bool map_record(const struct search *s, struct mapping *m, const members_type *members,
                       const struct frob_constructor *record);

static bool is_number(uint8_t type)
{
    return type == TYPE(FLOAT) || type == TYPE(DOUBLE);
}

static bool is_whole(uint8_t type)
{
    return type == TYPE(CHAR) || (type >= TYPE(OCTET) && type <= TYPE(INT64));
}

/* Returns the texts of an enumeration; NULL if it has none. */
static const struct frob_texts *texts_of(const struct frob_node *node,
                                         const struct frob_value *value)
{
    for (size_t k = 0; node != NULL && k < node->text_count; k++)
        if (node->texts[k].constructors == value->constructors)
            return &node->texts[k];
    return NULL;
}

/* Returns what a Maybe contains; NULL if the value is not a Maybe. */
static const struct frob_value *maybe_of(const struct frob_value *value)
{
    return value->kind == FROB_SUM && !value->is_event && value->count == 2 &&
                   value->constructors[0].count == 0 && value->constructors[1].count == 1
               ? value->constructors[1].fields[0].value
               : NULL;
}

/* Prepares the mapping of a text. Returns false if the value is not one. */
static bool is_text(const struct search *s, struct mapping *m, const struct frob_value *value)
{
    const struct frob_value *inner = maybe_of(value);
    m->texts = texts_of(s->node, inner == NULL ? value : inner);
    if (m->texts == NULL)
        return false;
    m->optional = inner == NULL ? NULL : value;
    m->value = inner == NULL ? value : inner;
    m->kind = MAPPING_TEXT;
    return true;
}

/* Maps one value, which may be an element of the member. */
static bool map_one(const struct search *s, struct mapping *m, const member_type *member,
                    const struct frob_value *value)
{
    m->member = member;
    m->value = value;
    if (is_text(s, m, value))
        return member->type_id_ == TYPE(STRING) || refuse(s, member, "a text");
    m->kind = MAPPING_NUMBER;
    switch (value->kind) {
    case FROB_BOOL: return member->type_id_ == TYPE(BOOLEAN) || refuse(s, member, "a Bool");
    case FROB_INT: return is_whole(member->type_id_) || refuse(s, member, "an Int");
    case FROB_FLOAT:
    case FROB_SINGLE:
    case FROB_ROUNDED: return is_number(member->type_id_) || refuse(s, member, "a Float");
    case FROB_PRODUCT:
        if (member->type_id_ != TYPE(MESSAGE))
            return refuse(s, member, "a record");
        return map_record(s, m, members_of(member->members_), &value->constructors[0]);
    case FROB_ARRAY:
    case FROB_SUM:
    case FROB_IMAGE: break;
    }
    return refuse(s, member, "a value that messages cannot have");
}

static bool room_for(const struct search *s, struct mapping *m, size_t count)
{
    m->parts = (struct mapping *)calloc(count + 1, sizeof *m->parts);
    m->part_count = count;
    if (m->parts == NULL)
        snprintf(s->why, s->room, "not enough memory");
    return m->parts != NULL;
}

static bool map_elements(const struct search *s, struct mapping *m, const member_type *member,
                         const struct frob_value *array)
{
    const struct frob_constructor *elements = &array->constructors[0];
    m->member = member;
    m->kind = m->count != NULL ? MAPPING_SEQUENCE : MAPPING_ARRAY;
    if (!room_for(s, m, elements->count))
        return false;
    for (size_t k = 0; k < elements->count; k++)
        if (!map_one(s, &m->parts[k], member, elements->fields[k].value))
            return false;
    return true;
}

/* Returns whether the value is an Upto, which has a count and an array. */
static bool is_upto(const struct frob_value *value)
{
    return value->kind == FROB_PRODUCT && value->constructors[0].count == 2 &&
           value->constructors[0].fields[0].value->kind == FROB_INT &&
           value->constructors[0].fields[1].value->kind == FROB_ARRAY;
}

static bool map_member(const struct search *s, struct mapping *m, const member_type *member,
                       const struct frob_value *value)
{
    const bool is_sequence =
        member->is_array_ && (member->array_size_ == 0 || member->is_upper_bound_);
    if (is_sequence && is_upto(value)) {
        const struct frob_constructor *upto = &value->constructors[0];
        const struct frob_value *array = upto->fields[1].value;
        m->count = upto->fields[0].value;
        if (member->is_upper_bound_ && array->constructors[0].count > member->array_size_) {
            snprintf(s->why, s->room,
                     "in %s, `%s` has at most %zu elements, but in the record `%s` %zu: declare it "
                     "with this maximum",
                     s->type, member->name_, member->array_size_, s->record,
                     array->constructors[0].count);
            return false;
        }
        return map_elements(s, m, member, array);
    }
    if (member->is_array_ && value->kind == FROB_ARRAY) {
        const size_t count = value->constructors[0].count;
        if (!is_sequence && member->array_size_ != count) {
            snprintf(s->why, s->room,
                     "in %s, `%s` has %zu elements, but in the record `%s` %zu: declare it as an "
                     "`Array %zu`",
                     s->type, member->name_, member->array_size_, s->record, count,
                     member->array_size_);
            return false;
        }
        return map_elements(s, m, member, value);
    }
    if (member->is_array_ || value->kind == FROB_ARRAY) {
        return refuse(s, member,
                      value->kind == FROB_ARRAY ? "an array" : "neither an array nor an `Upto`");
    }
    return map_one(s, m, member, value);
}

/* Determines whether the record leaves out the stamp or the frame of its header. */
static void find_header(struct mapping *m, const members_type *members)
{
    if (!has_header(members))
        return;
    m->header = &members->members_[0];
    m->sets_stamp = m->sets_frame = true;
    for (size_t k = 0; k < m->part_count; k++)
        for (size_t i = 0; m->parts[k].member == m->header && i < m->parts[k].part_count; i++) {
            const char *name = m->parts[k].parts[i].member->name_;
            m->sets_stamp = m->sets_stamp && strcmp(name, "stamp") != 0;
            m->sets_frame = m->sets_frame && strcmp(name, "frame_id") != 0;
        }
}

static bool map_record(const struct search *outer, struct mapping *m, const members_type *members,
                       const struct frob_constructor *record)
{
    struct search inner = *outer;
    const struct search *s = &inner;
    inner.record = record->name;
    m->kind = MAPPING_RECORD;
    if (!room_for(s, m, record->count))
        return false;
    for (size_t k = 0; k < record->count; k++) {
        const struct frob_field *field = &record->fields[k];
        const member_type *member = member_named(members, field->name);
        if (member == NULL) {
            snprintf(s->why, s->room,
                     "%s has no field for `%s` of the record `%s`: rename or remove it", s->type,
                     field->name, record->name);
            return false;
        }
        if (!map_member(s, &m->parts[k], member, field->value))
            return false;
    }
    find_header(m, members);
    return true;
}

bool mapping_of(struct mapping *m, const struct message_type *type, const struct frob_value *value,
                const struct frob_node *node, char *why, size_t room)
{
    const struct search s = { why, room, type->name, NULL, node };
    memset(m, 0, sizeof *m);
    m->kind = MAPPING_RECORD;
    if (value == NULL)
        return true;
    if (value->kind == FROB_PRODUCT && texts_of(node, value) == NULL)
        return value->constructors[0].count == 0 ||
               map_record(&s, m, type->members, &value->constructors[0]);
    /* A Bool, Int, Float or text is the only member, `data`. */
    return room_for(&s, m, 1) && map_one(&s, &m->parts[0], &type->members->members_[0], value);
}

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
    /* A product has one constructor, and no tag. */
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
    /* The empty text is published for Nothing. */
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

/* ---- Values. `place`: the record, the number or the element in the message. */

static bool read_at(const struct mapping *m, const void *place, void *values,
                    struct mapping_fault *fault);

static const void *member_in(const struct mapping *m, const void *record)
{
    return (const char *)record + m->member->offset_;
}

/* Elements beyond the end of a sequence keep the values that they had. */
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
