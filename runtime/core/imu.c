#include <frob/imu.h>

#include <frob/camera.h>

#include <string.h>

static void set_vector(void *input, const struct frob_value *value, const double numbers[3])
{
    for (size_t i = 0; i < 3; i++)
        frob_camera_set_number(input, value->constructors[0].fields[i].value, numbers[i]);
}

/* Sets the value to `Just heading` or, if the heading is NaN, to `Nothing` with 0 in the
 * payload. */
static void set_heading(void *input, const struct frob_value *value, double heading)
{
    const int is_known = heading <= 4.0;
    unsigned char just = 0;
    while (value->constructors[just].count == 0)
        just++;
    ((unsigned char *)input)[value->offset] = (unsigned char)(is_known ? just : 1 - just);
    frob_camera_set_number(input, value->constructors[just].fields[0].value,
                           is_known ? heading : 0.0);
}

void frob_imu_give(const struct frob_control *imu, void *input, const struct frob_imu *reading,
                   int64_t now_ns)
{
    static const struct frob_imu none;
    const struct frob_constructor *record =
        imu->value->constructors[1].fields[0].value->constructors;
    const int occurs = reading != NULL;
    ((unsigned char *)input)[imu->value->offset] = (unsigned char)occurs;
    if (reading == NULL)
        reading = &none;
    for (size_t i = 0; i < record->count; i++) {
        const struct frob_value *value = record->fields[i].value;
        const char *name = record->fields[i].name;
        if (strcmp(name, "rate") == 0)
            set_vector(input, value, reading->rate_radps);
        else if (strcmp(name, "acceleration") == 0)
            set_vector(input, value, reading->acceleration_mps2);
        else if (strcmp(name, "heading") == 0)
            set_heading(input, value, reading->heading_rad);
        else if (strcmp(name, "age") == 0)
            frob_camera_set_number(input, value,
                                   occurs ? (double)(now_ns - reading->taken_ns) / 1e9 : 0.0);
        else
            frob_camera_set_number(input, value, (double)(reading->number & INT32_MAX));
    }
}
