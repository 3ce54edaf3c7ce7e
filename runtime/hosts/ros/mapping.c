#include "mapping.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <rosidl_typesupport_introspection_c/field_types.h>

#include "late.h"

#define TYPE(name) rosidl_typesupport_introspection_c__ROS_TYPE_##name

typedef rosidl_typesupport_introspection_c__MessageMember member_type;
typedef rosidl_typesupport_introspection_c__MessageMembers members_type;

static const char introspection[] = "rosidl_typesupport_introspection_c";

/* ---- Message types */

static const members_type *members_of(const rosidl_message_type_support_t *support)
{
    const rosidl_message_type_support_t *found =
        support == NULL ? NULL : support->func(support, introspection);
    return found == NULL ? NULL : (const members_type *)found->data;
}

bool message_type_find(struct message_type *type, const char *name, char *why, size_t room)
{
    char package[128];
    const char *last = strrchr(name, '/');
    memset(type, 0, sizeof *type);
    type->name = name;
    snprintf(package, sizeof package, "%.*s", (int)strcspn(name, "/"), name);
    if (!late_messages(package, why, room))
        return false;
    type->support = late_message_type(package, last + 1);
    type->members = members_of(type->support);
    if (type->members == NULL)
        snprintf(why, room, "the package %s of this ROS 2 installation has no message %s", package,
                 last + 1);
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

/* Returns whether the name of a record's field matches the name of a message's member: angleMin
 * matches angle_min, and data_ matches data. */
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
    const char *type;   /* type of the whole message */
    const char *record; /* the record that contains the value; NULL if the value is the whole
                         * message */
    const struct frob_node *node;
};

/* Returns the type that the program must declare for a member. */
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
             type == NULL ? "omit the field" : "declare it as ", type == NULL ? "" : several,
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

/* Returns the strings of an enumeration; NULL if it has none. */
static const struct frob_texts *texts_of(const struct frob_node *node,
                                         const struct frob_value *value)
{
    for (size_t k = 0; node != NULL && k < node->text_count; k++)
        if (node->texts[k].constructors == value->constructors)
            return &node->texts[k];
    return NULL;
}

/* Returns the content type of a Maybe; NULL if the value is not a Maybe. */
static const struct frob_value *maybe_of(const struct frob_value *value)
{
    return value->kind == FROB_SUM && !value->is_event && value->count == 2 &&
                   value->constructors[0].count == 0 && value->constructors[1].count == 1
               ? value->constructors[1].fields[0].value
               : NULL;
}

/* Prepares the mapping of a value to a string. Returns false if the value is not an enumeration
 * with strings, or a Maybe of one. */
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

/* Maps a single value: a member, or one element of it. */
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
    return refuse(s, member, "a value that messages cannot contain");
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
                     "in %s, `%s` has at most %zu elements, but in the record `%s` it has at most "
                     "%zu: declare it with the maximum of the message",
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
                     "in %s, `%s` has %zu elements, but in the record `%s` it has %zu: declare it "
                     "as an `Array %zu`",
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

/* Determines whether the record omits the stamp or the frame of its header. */
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
    /* A Bool, Int, Float or string corresponds to the message's only member, `data`. */
    return room_for(&s, m, 1) && map_one(&s, &m->parts[0], &type->members->members_[0], value);
}
