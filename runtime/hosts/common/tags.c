#include <frob/tags.h>

#include <frob/camera.h>
#include <frob/lens.h>

#include <string.h>

static unsigned char *place(void *base, const struct frob_value *value)
{
    return (unsigned char *)base + value->offset;
}

/* Sets the numeric leaves of a value in the order in which the library's module Tags declares them.
 * The value must not contain sum types. */
static void set_numbers(void *input, const struct frob_value *value, const double **next)
{
    if (value->kind == FROB_PRODUCT || value->kind == FROB_ARRAY) {
        for (size_t i = 0; i < value->constructors[0].count; i++)
            set_numbers(input, value->constructors[0].fields[i].value, next);
        return;
    }
    frob_camera_set_number(input, value, *(*next)++);
}

/* Sets the lens to that of the image, or to all zeros if there is no image. */
static void set_lens(void *input, const struct frob_value *value, const struct frob_image *image)
{
    struct frob_lens lens;
    memset(&lens, 0, sizeof lens);
    if (image != NULL)
        frob_image_lens(image, &lens);
    {
        const double numbers[] = { lens.width,   lens.height,  lens.focalX, lens.focalY,
                                   lens.centreX, lens.centreY, lens.k1,     lens.k2,
                                   lens.k3,      lens.p1,      lens.p2,     lens.ahead,
                                   lens.left,    lens.up,      lens.yaw,    lens.pitch,
                                   lens.roll };
        const double *next = numbers;
        set_numbers(input, value, &next);
    }
}

/* Sets `Just tag`, or `Nothing` for NULL, with zeros as its payload. */
static void set_tag(void *input, const struct frob_value *value, const struct frob_tag *tag)
{
    struct frob_tag none;
    unsigned char just = 0;
    while (value->constructors[just].count == 0)
        just++;
    *place(input, value) = (unsigned char)(tag != NULL ? just : 1 - just);
    memset(&none, 0, sizeof none);
    if (tag == NULL)
        tag = &none;
    {
        const struct frob_vec2 *p = tag->corners;
        const double numbers[] = { tag->id, tag->middle.x, tag->middle.y, p[0].x,
                                   p[0].y,  p[1].x,        p[1].y,        p[2].x,
                                   p[2].y,  p[3].x,        p[3].y,        tag->margin };
        const double *next = numbers;
        set_numbers(input, value->constructors[just].fields[0].value, &next);
    }
}

void frob_tags_give(const struct frob_control *control, void *input, const struct frob_image *image,
                    const struct frob_tags *tags, int64_t now_ns)
{
    const struct frob_constructor *frame =
        control->value->constructors[1].fields[0].value->constructors;
    *place(input, control->value) = image != NULL;
    for (size_t i = 0; i < frame->count; i++) {
        const struct frob_field *field = &frame->fields[i];
        if (field->value->kind == FROB_PRODUCT)
            set_lens(input, field->value, image);
        else if (field->value->kind == FROB_ARRAY)
            for (size_t k = 0; k < field->value->constructors[0].count; k++)
                set_tag(input, field->value->constructors[0].fields[k].value,
                        tags != NULL && k < tags->count ? &tags->each[k] : NULL);
        else
            frob_camera_give_number(field, input, image, now_ns);
    }
}
