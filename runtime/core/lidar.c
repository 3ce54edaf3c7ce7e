#include <frob/lidar.h>

#include <frob/camera.h>

#include <math.h>
#include <string.h>

static const double two_pi = 6.28318530717958647692;

size_t frob_lidar_label(const struct frob_control *control)
{
    const char *space = control->kind == FROB_LIDAR ? strrchr(control->label, ' ') : NULL;
    return space == NULL ? 0 : (size_t)(space - control->label);
}

/* The number of the constructor `Just` of a Maybe: 0 or 1. `Nothing` has the other number. */
static unsigned char just(const struct frob_value *maybe)
{
    return maybe->constructors[0].count == 0 ? 1 : 0;
}

static void set_nothing(void *input, const struct frob_value *maybe)
{
    const unsigned char is_just = just(maybe);
    ((unsigned char *)input)[maybe->offset] = (unsigned char)(1 - is_just);
    frob_camera_set_number(input, maybe->constructors[is_just].fields[0].value, 0.0);
}

static double number_at(const void *input, const struct frob_value *value)
{
    const unsigned char *place = (const unsigned char *)input + value->offset;
    double x;
    float single;
    if (value->kind == FROB_SINGLE) {
        memcpy(&single, place, sizeof single);
        return single;
    }
    memcpy(&x, place, sizeof x);
    return x;
}

/* Sets the distance in a direction, unless a smaller one has already been set. */
static void offer(void *input, const struct frob_value *maybe, double distance)
{
    const unsigned char is_just = just(maybe);
    unsigned char *tag = (unsigned char *)input + maybe->offset;
    const struct frob_value *number = maybe->constructors[is_just].fields[0].value;
    if (*tag == is_just && number_at(input, number) <= distance)
        return;
    *tag = is_just;
    frob_camera_set_number(input, number, distance);
}

/* Applies the distance of a ray to the direction in whose sector the ray lies, and to all
 * directions within `half_step` of its bearing. */
static void spread(void *input, const struct frob_constructor *ranges, double bearing,
                   double half_step, double distance)
{
    const double count = (double)ranges->count, width = two_pi / count;
    const double own = floor(bearing / width + 0.5);
    const double first = fmin(own, ceil((bearing - half_step) / width));
    const double last = fmax(own, floor((bearing + half_step) / width));
    for (double k = first; k <= last && k < first + count; k += 1.0)
        offer(input, ranges->fields[(size_t)(k - count * floor(k / count))].value, distance);
}

static void set_ranges(void *input, const struct frob_constructor *ranges,
                       const struct frob_scan *scan)
{
    /* Slightly more than half, so that rounding does not leave a direction between two rays
     * empty. */
    const double half_step = scan == NULL ? 0.0 : 0.500001 * scan->step_rad;
    for (size_t k = 0; k < ranges->count; k++)
        set_nothing(input, ranges->fields[k].value);
    for (size_t i = 0; scan != NULL && i < scan->count; i++) {
        const double range = scan->ranges_m[i];
        if (range >= scan->nearest_m) /* not NaN */
            spread(input, ranges, scan->first_rad + (double)i * scan->step_rad, half_step,
                   fmin(range, scan->farthest_m));
    }
}

static double number_of(const char *name, const struct frob_scan *scan, int64_t now_ns)
{
    if (scan == NULL)
        return 0.0;
    if (strcmp(name, "age") == 0)
        return (double)(now_ns - scan->taken_ns) / 1e9;
    if (strcmp(name, "nearest") == 0)
        return scan->nearest_m;
    if (strcmp(name, "farthest") == 0)
        return scan->farthest_m;
    return (double)(scan->number & INT32_MAX);
}

void frob_lidar_give(const struct frob_control *lidar, void *input, const struct frob_scan *scan,
                     int64_t now_ns)
{
    const struct frob_constructor *record =
        lidar->value->constructors[1].fields[0].value->constructors;
    ((unsigned char *)input)[lidar->value->offset] = scan != NULL;
    for (size_t i = 0; i < record->count; i++) {
        const struct frob_field *field = &record->fields[i];
        if (field->value->kind == FROB_ARRAY) {
            set_ranges(input, field->value->constructors, scan);
        } else if (field->value->kind == FROB_PRODUCT) {
            const struct frob_field *place = field->value->constructors[0].fields;
            frob_camera_set_number(input, place[0].value, scan == NULL ? 0.0 : scan->x_m);
            frob_camera_set_number(input, place[1].value, scan == NULL ? 0.0 : scan->y_m);
        } else {
            frob_camera_set_number(input, field->value, number_of(field->name, scan, now_ns));
        }
    }
}
