#include <frob/console.h>

#include <string.h>

/* The event of the field `key`; NULL if there is none. */
static const struct frob_value *find_key(const struct frob_value *input)
{
    const struct frob_constructor *record;
    if (input == NULL || input->kind != FROB_PRODUCT)
        return NULL;
    record = &input->constructors[0];
    for (size_t i = 0; i < record->count; i++) {
        const struct frob_field *field = &record->fields[i];
        if (field->name != NULL && strcmp(field->name, "key") == 0 && field->value->is_event &&
            field->value->constructors[1].fields[0].value->kind == FROB_INT)
            return field->value;
    }
    return NULL;
}

void frob_console_key(const struct frob_program *program, void *input, int32_t key)
{
    const struct frob_value *event = find_key(program->input);
    unsigned char *bytes = (unsigned char *)input;
    if (event == NULL)
        return;
    bytes[event->offset] = key >= 0; /* the tag: NoEvent, Event */
    if (key >= 0)
        memcpy(bytes + event->constructors[1].fields[0].value->offset, &key, sizeof key);
}
