/* blob.c -- the tracker and its parts; see blob.h. */
#include "blob.h"
#include "blob_tracker.h"

/* Minimum brightness of a pixel that counts as part of the blob. */
static const int32_t bright = 128;

/* Maximum distance from the blob at which the tracker looks for it in the next picture, in
 * pixels. */
static const int32_t margin = 2;

static int32_t limited(int32_t n, int32_t most)
{
    return n < 0 ? 0 : n > most ? most : n;
}

/* {1 The parts} */

/* Marks the pixels that are at least as bright as the threshold. */
void blob_brighter(int32_t threshold, const int32_t *picture, bool *result)
{
    for (int i = 0; i < BLOB_PIXELS; i++)
        result[i] = picture[i] >= threshold;
}

/* Computes the centre and the size of the marked pixels in a window; Nothing if there are none. */
void blob_measure(const struct frob_window *w, const bool *mask, struct frob_maybe_blob *result)
{
    const struct frob_maybe_blob nothing = { .tag = FROB_MAYBE_BLOB_NOTHING };
    int32_t count = 0, columns = 0, rows = 0;
    for (int32_t row = w->top; row <= w->bottom; row++)
        for (int32_t column = w->left; column <= w->right; column++)
            if (mask[row * BLOB_WIDTH + column]) {
                count++;
                columns += column;
                rows += row;
            }
    *result = nothing;
    if (count > 0) {
        result->tag = FROB_MAYBE_BLOB_JUST;
        result->f0 = (double)columns / count; /* column */
        result->f1 = (double)rows / count;    /* row */
        result->i0 = count;                   /* size */
    }
}

/* The window to search next, around the centre of a blob. */
void blob_around(const struct frob_blob *b, struct frob_window *result)
{
    const int32_t column = (int32_t)(b->column + 0.5), row = (int32_t)(b->row + 0.5);
    result->left = limited(column - margin, BLOB_WIDTH - 1);
    result->right = limited(column + margin, BLOB_WIDTH - 1);
    result->top = limited(row - margin, BLOB_HEIGHT - 1);
    result->bottom = limited(row + margin, BLOB_HEIGHT - 1);
}

/* {1 The whole tracker} */

static void look_everywhere(struct blob_state *self)
{
    self->left = self->top = 0;
    self->right = BLOB_WIDTH - 1;
    self->bottom = BLOB_HEIGHT - 1;
}

void blob_reset(struct blob_state *self)
{
    look_everywhere(self);
}

/* Processes one picture. Ignores dt, the time since the previous one in seconds. */
void blob_step(struct blob_state *self, double dt, const struct blob_input *in,
               struct blob_output *out)
{
    bool mask[BLOB_PIXELS];
    struct frob_maybe_blob found;
    const struct frob_window window = { self->left, self->top, self->right, self->bottom };
    (void)dt;
    blob_brighter(bright, in->value, mask);
    blob_measure(&window, mask, &found);

    out->value.tag = FROB_EVENT_BLOB_NO_EVENT;
    out->value.f0 = found.f0;
    out->value.f1 = found.f1;
    out->value.i0 = found.i0;
    if (found.tag == FROB_MAYBE_BLOB_JUST) {
        const struct frob_blob blob = { found.f0, found.f1, found.i0 };
        struct frob_window next;
        blob_around(&blob, &next);
        out->value.tag = FROB_EVENT_BLOB_EVENT;
        self->left = next.left;
        self->top = next.top;
        self->right = next.right;
        self->bottom = next.bottom;
    } else {
        look_everywhere(self);
    }
}
