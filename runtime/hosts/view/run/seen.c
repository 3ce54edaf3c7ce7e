#include "seen.h"

#include <frob/camera.h>
#include <frob/lens.h>

#include <stdlib.h>
#include <string.h>

bool seen_is_eye(const struct frob_value *value)
{
    return value->kind == FROB_SUM && value->is_event && frames_has_images(value);
}

/* Finds the events that contain images and are not nested in other such events. Stores them in
 * `eyes`, unless it is NULL. Returns their number. */
static size_t find_eyes(const struct frob_value *value, const struct frob_value **eyes)
{
    size_t count = 0;
    if (seen_is_eye(value)) {
        if (eyes != NULL)
            *eyes = value;
        return 1;
    }
    if (value->kind == FROB_PRODUCT || value->kind == FROB_ARRAY)
        for (size_t i = 0; i < value->constructors[0].count; i++)
            count += find_eyes(value->constructors[0].fields[i].value,
                               eyes == NULL ? NULL : eyes + count);
    return count;
}

bool seen_start(struct recording *recording)
{
    const struct frob_value *input = recording->program->input;
    recording->eye_count = find_eyes(input, NULL);
    recording->eyes =
        (const struct frob_value **)calloc(recording->eye_count + 1, sizeof *recording->eyes);
    if (recording->eyes != NULL)
        find_eyes(input, recording->eyes);
    return recording->eyes != NULL;
}

/* Returns the part in brackets of the frame reader's last message, which contains the path and the
 * reason. */
static const char *reason(const struct recording *recording)
{
    const char *said = strchr(recording->frames.expected, '(');
    return said == NULL ? "" : said;
}

void seen_lose(struct recording *recording, size_t k, unsigned char *input,
               const struct frob_value *eye, uint32_t number, bool is_there)
{
    const struct lost_frame lost = { k, number, is_there };
    struct lost_frame *all = (struct lost_frame *)realloc(
        recording->lost, (recording->lost_count + 1) * sizeof *recording->lost);
    input[eye->offset] = 0;
    if (k < recording->gap)
        recording->gap = k;
    if (all == NULL)
        return;
    recording->lost = all;
    recording->lost[recording->lost_count++] = lost;
    if (recording->lost_count > 1)
        return;
    buffer_format(&recording->notes, "%s: frame %lu at instant %lu is not %s%s", recording->name,
                  (unsigned long)number, (unsigned long)k,
                  is_there ? "the recorded frame: its file was changed" : "available ",
                  is_there ? "" : reason(recording));
    buffer_text(&recording->notes,
                "; from this instant on, the viewer only shows recorded inputs and outputs\n");
}

struct look {
    const struct frob_image *image;
    const int32_t *key;
};

static void look_at(void *context, const struct frob_image **image)
{
    struct look *look = (struct look *)context;
    if (look->image == NULL && (look->key == NULL || frob_image_key(*image) == *look->key))
        look->image = *image;
}

/* Returns the image of an event in the input of an instant; NULL if there is none. */
static const struct frob_image *image_at(const struct recording *recording, size_t eye, size_t k,
                                         const int32_t *key)
{
    struct look look = { NULL, key };
    frob_camera_images(recording->eyes[eye], recording->inputs + k * recording->program->input_size,
                       look_at, &look);
    return look.image;
}

void seen_check(struct recording *recording, size_t end)
{
    for (; recording->checked < end && recording->eye_count > 0; recording->checked++) {
        const size_t k = recording->checked;
        for (size_t i = 0; i < recording->eye_count; i++) {
            const struct frob_image *image = image_at(recording, i, k, NULL);
            if (image != NULL && !frame_reader_is_unchanged(image))
                seen_lose(recording, k, recording->inputs + k * recording->program->input_size,
                          recording->eyes[i], image->number, true);
        }
    }
}

const struct frob_image *seen_image(const struct recording *recording, const int32_t *key,
                                    size_t *k)
{
    for (;; --*k) {
        for (size_t i = 0; i < recording->eye_count; i++) {
            const struct frob_image *image = image_at(recording, i, *k, key);
            if (image != NULL)
                return image;
        }
        if (*k == 0)
            return NULL;
    }
}

const struct lost_frame *seen_lost(const struct recording *recording, size_t k)
{
    const struct lost_frame *newest = NULL;
    for (size_t i = 0; i < recording->lost_count; i++)
        if (recording->lost[i].k <= k && (newest == NULL || recording->lost[i].k >= newest->k))
            newest = &recording->lost[i];
    return newest;
}
