#include <frob/console.h>

#include <string.h>

/* Returns the event of the field `key`, or NULL if there is none. */
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
    bytes[event->offset] = key >= 0; /* the tag: 0 is NoEvent, 1 is Event */
    if (key >= 0)
        memcpy(bytes + event->constructors[1].fields[0].value->offset, &key, sizeof key);
}

bool frob_console_is_on(const struct frob_program *program, const struct frob_value *value)
{
    for (size_t i = 0; i < program->control_count; i++)
        if (program->console[i].value == value)
            return true;
    return false;
}

static void set_flag(void *input, const struct frob_value *value, bool flag)
{
    memcpy((unsigned char *)input + value->offset, &flag, sizeof flag);
}

static void set_number(void *input, const struct frob_value *value, double x)
{
    unsigned char *place = (unsigned char *)input + value->offset;
    if (value->kind == FROB_SINGLE) {
        float rounded = (float)x;
        memcpy(place, &rounded, sizeof rounded);
    } else {
        memcpy(place, &x, sizeof x);
    }
}

static void set_event(void *input, const struct frob_value *event, bool occurs)
{
    ((unsigned char *)input)[event->offset] = occurs; /* the tag: 0 is NoEvent, 1 is Event */
}

/* Clamps x to the control's range. */
static double within(const struct frob_control *control, double x)
{
    return x < control->least ? control->least : x > control->most ? control->most : x;
}

void frob_console_start(const struct frob_program *program, void *input)
{
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        if (control->kind == FROB_KNOB)
            set_number(input, control->value, control->first);
        else if (control->kind == FROB_TOGGLE)
            set_flag(input, control->value, control->first > 0.0);
    }
    frob_console_clear(program, input);
    frob_console_release(program, input);
}

size_t frob_console_find(const struct frob_program *program, const char *label)
{
    size_t i = 0;
    while (i < program->control_count && strcmp(program->console[i].label, label) != 0)
        i++;
    return i;
}

bool frob_console_touch(const struct frob_program *program, void *input, size_t control, double x,
                        double y)
{
    const struct frob_control *touched;
    const struct frob_field *place;
    if (control >= program->control_count || x != x || y != y)
        return false;
    touched = &program->console[control];
    switch (touched->kind) {
    case FROB_BUTTON: set_event(input, touched->value, true); break;
    case FROB_HOLD:
    case FROB_TOGGLE: set_flag(input, touched->value, x < 0.0 || x > 0.0); break;
    case FROB_KNOB: set_number(input, touched->value, within(touched, x)); break;
    case FROB_MAP:
        set_event(input, touched->value, true);
        /* Event (x, y) */
        place = touched->value->constructors[1].fields[0].value->constructors[0].fields;
        set_number(input, place[0].value, x);
        set_number(input, place[1].value, y);
        break;
    case FROB_CAMERA:
    case FROB_TAGS:
    case FROB_LIDAR:
    case FROB_IMU: return false;
    }
    return true;
}

void frob_console_clear(const struct frob_program *program, void *input)
{
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        if (control->kind == FROB_BUTTON || control->kind == FROB_MAP)
            set_event(input, control->value, false);
    }
}

void frob_console_release(const struct frob_program *program, void *input)
{
    for (size_t i = 0; i < program->control_count; i++)
        if (program->console[i].kind == FROB_HOLD)
            set_flag(input, program->console[i].value, false);
}
