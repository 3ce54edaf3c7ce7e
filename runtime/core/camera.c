#include <frob/camera.h>

#include <string.h>

static unsigned char *place(void *base, const struct frob_value *value)
{
    return (unsigned char *)base + value->offset;
}

size_t frob_camera_label(const struct frob_control *control)
{
    static const char ending[] = " tags";
    const size_t length = strlen(control->label);
    return control->kind == FROB_CAMERA ? length
           : control->kind == FROB_TAGS ? length - (sizeof ending - 1)
                                        : 0;
}

void frob_camera_set_number(void *input, const struct frob_value *value, double x)
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

void frob_camera_give_number(const struct frob_field *field, void *input,
                             const struct frob_image *image, int64_t now_ns)
{
    double x = 0.0;
    if (image != NULL && strcmp(field->name, "age") == 0)
        x = (double)(now_ns - image->captured_ns) / 1e9;
    else if (image != NULL)
        x = (double)(image->number & INT32_MAX);
    frob_camera_set_number(input, field->value, x);
}

void frob_camera_give(const struct frob_control *camera, void *input,
                      const struct frob_image *image, int64_t now_ns)
{
    const struct frob_constructor *frame =
        camera->value->constructors[1].fields[0].value->constructors;
    const unsigned char occurs = image != NULL;
    memcpy(place(input, camera->value), &occurs, sizeof occurs);
    for (size_t i = 0; i < frame->count; i++) {
        const struct frob_field *field = &frame->fields[i];
        if (field->value->kind == FROB_IMAGE)
            memcpy(place(input, field->value), &image, sizeof image);
        else
            frob_camera_give_number(field, input, image, now_ns);
    }
}

void frob_camera_images(const struct frob_value *value, void *base, frob_image_visitor *visit,
                        void *context)
{
    if (value->kind == FROB_IMAGE) {
        const struct frob_image **image = (const struct frob_image **)(void *)place(base, value);
        if (*image != NULL)
            visit(context, image);
    } else if (value->kind == FROB_SUM) {
        const unsigned char tag = *place(base, value);
        if (tag < value->count)
            for (size_t i = 0; i < value->constructors[tag].count; i++)
                frob_camera_images(value->constructors[tag].fields[i].value, base, visit, context);
    } else if (value->kind == FROB_PRODUCT || value->kind == FROB_ARRAY) {
        for (size_t i = 0; i < value->constructors[0].count; i++)
            frob_camera_images(value->constructors[0].fields[i].value, base, visit, context);
    }
}
