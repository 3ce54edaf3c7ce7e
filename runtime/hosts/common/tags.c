#include <frob/tags.h>

#include <frob/lens.h>

#include <string.h>

static unsigned char *place(void *base, const struct frob_value *value)
{
    return (unsigned char *)base + value->offset;
}

static void set_number(void *input, const struct frob_value *value, double x)
{
    const float single = (float)x;
    const int32_t whole = value->kind == FROB_INT ? (int32_t)x : 0;
    if (value->kind == FROB_SINGLE)
        memcpy(place(input, value), &single, sizeof single);
    else if (value->kind == FROB_INT)
        memcpy(place(input, value), &whole, sizeof whole);
    else
        memcpy(place(input, value), &x, sizeof x);
}

/* Leaf by leaf, in the order in which the library's module Tags has them; 0 for what is beyond
 * the last. Sums are not among them. */
static void set_numbers(void *input, const struct frob_value *value, const double **next,
                        const double *end)
{
    if (value->kind == FROB_PRODUCT || value->kind == FROB_ARRAY) {
        for (size_t i = 0; i < value->constructors[0].count; i++)
            set_numbers(input, value->constructors[0].fields[i].value, next, end);
        return;
    }
    set_number(input, value, *next < end ? *(*next)++ : 0.0);
}

static void set_lens(void *input, const struct frob_value *value, const struct frob_image *image)
{
    double numbers[17];
    const double *next = numbers;
    struct frob_lens lens;
    size_t count = 0;
    if (image != NULL) {
        frob_image_lens(image, &lens);
        {
            const double all[17] = { lens.width, lens.height, lens.focalX, lens.focalY,
                                     lens.centreX, lens.centreY, lens.k1, lens.k2, lens.k3,
                                     lens.p1, lens.p2, lens.ahead, lens.left, lens.up,
                                     lens.yaw, lens.pitch, lens.roll };
            memcpy(numbers, all, sizeof numbers);
        }
        count = 17;
    }
    set_numbers(input, value, &next, numbers + count);
}

/* `Just` it, or `Nothing` for NULL; what is behind a tag that is not there is 0. */
static void set_tag(void *input, const struct frob_value *value, const struct frob_tag *tag)
{
    double numbers[12];
    const double *next = numbers;
    size_t count = 0;
    unsigned char just = 0;
    while (value->constructors[just].count == 0)
        just++;
    if (tag != NULL) {
        numbers[count++] = tag->id;
        numbers[count++] = tag->middle.x;
        numbers[count++] = tag->middle.y;
        for (size_t i = 0; i < 4; i++) {
            numbers[count++] = tag->corners[i].x;
            numbers[count++] = tag->corners[i].y;
        }
        numbers[count++] = tag->margin;
    }
    set_numbers(input, value->constructors[just].fields[0].value, &next, numbers + count);
    *place(input, value) = (unsigned char)(tag != NULL ? just : 1 - just);
}

size_t frob_tags_camera(const struct frob_control *control)
{
    static const char ending[] = " tags";
    return strlen(control->label) - (sizeof ending - 1);
}

void frob_tags_give(const struct frob_control *control, void *input,
                    const struct frob_image *image, const struct frob_tags *tags, int64_t now_ns)
{
    const struct frob_constructor *frame =
        control->value->constructors[1].fields[0].value->constructors;
    *place(input, control->value) = image != NULL;
    for (size_t i = 0; i < frame->count; i++) {
        const struct frob_value *value = frame->fields[i].value;
        const char *name = frame->fields[i].name;
        if (value->kind == FROB_PRODUCT)
            set_lens(input, value, image);
        else if (value->kind == FROB_ARRAY)
            for (size_t k = 0; k < value->constructors[0].count; k++)
                set_tag(input, value->constructors[0].fields[k].value,
                        tags != NULL && k < tags->count ? &tags->each[k] : NULL);
        else if (image == NULL)
            set_number(input, value, 0.0);
        else if (strcmp(name, "age") == 0)
            set_number(input, value, (double)(now_ns - image->captured_ns) / 1e9);
        else
            set_number(input, value, (double)(image->number & INT32_MAX));
    }
}
