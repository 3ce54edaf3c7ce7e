/* components.c -- finds the largest connected sets of pixels in a colour range.
 *
 * It processes the image row by row. If a run of such pixels touches runs in the row above, it
 * joins their component; if those runs belong to several components, the components are merged.
 * Only the row above is kept. A component without a run in the current row is complete: it is kept
 * if it is among the eight largest so far, and discarded otherwise. */
#include "colour.h"
#include "moments.h"

#include <string.h>

/* Maximum number of components that have a run in the row above or started in this row. A component
 * that started in this row touches no run above, so all these runs are separated by at least one
 * column. */
enum { MOST = FROB_IMAGE_SIDE / 2 + 1, KEPT = 8 };

struct run {
    int32_t start, end;
    int32_t component;
};

struct row {
    struct run runs[MOST];
    int32_t count;
};

struct components {
    struct frob_moments moments[MOST];
    int32_t joined[MOST]; /* the component it was merged into in this row, or itself */
    int32_t last[MOST];   /* the row of its last run */
    int32_t free[MOST];
    int32_t free_count;
    struct frob_moments largest[KEPT];
    int32_t count;
};

static bool is_before(const struct frob_moments *a, const struct frob_moments *b)
{
    if (a->count != b->count)
        return a->count > b->count;
    return a->top != b->top ? a->top < b->top : a->left < b->left;
}

static void keep_if_large(struct components *all, const struct frob_moments *done)
{
    int32_t place = all->count;

    while (place > 0 && is_before(done, &all->largest[place - 1]))
        place--;
    if (place == KEPT)
        return;
    if (all->count < KEPT)
        all->count++;
    for (int32_t i = all->count - 1; i > place; i--)
        all->largest[i] = all->largest[i - 1];
    all->largest[place] = *done;
}

static int32_t whole(struct components *all, int32_t part)
{
    while (all->joined[part] != part) {
        all->joined[part] = all->joined[all->joined[part]];
        part = all->joined[part];
    }
    return part;
}

static int32_t begin(struct components *all)
{
    const int32_t component = all->free[--all->free_count];

    all->joined[component] = component;
    all->moments[component] = frob_no_moments();
    return component;
}

/* Returns the component of a run, after merging the components of all runs above that it touches.
 * Starts at run *first of the row above, and sets *first to the first run that may also touch the
 * next run. */
static int32_t component_of(struct components *all, const struct row *above, int32_t *first,
                            int32_t start, int32_t end)
{
    int32_t found = -1;

    while (*first < above->count && above->runs[*first].end < start)
        ++*first;
    for (int32_t i = *first; i < above->count && above->runs[i].start <= end; i++) {
        const int32_t other = whole(all, above->runs[i].component);
        if (found < 0) {
            found = other;
        } else if (other != found) {
            frob_add_moments(&all->moments[found], &all->moments[other]);
            all->joined[other] = found;
        }
        *first = i;
    }
    return found < 0 ? begin(all) : found;
}

/* Frees the components of the row above that were merged into another or are complete. Each
 * component is handled once, at its first run. */
static void end_row(struct components *all, const struct row *above, int32_t y)
{
    for (int32_t i = 0; i < above->count; i++) {
        const int32_t component = above->runs[i].component;
        const bool joined = all->joined[component] != component;
        if (all->last[component] == -1 || (!joined && all->last[component] == y))
            continue;
        if (!joined)
            keep_if_large(all, &all->moments[component]);
        all->last[component] = -1;
        all->free[all->free_count++] = component;
    }
}

static void find(const struct frob_image *image, const struct frob_view *view,
                 const struct frob_colours *colours, struct components *all)
{
    struct row rows[2];
    uint8_t mask[FROB_IMAGE_SIDE];

    rows[0].count = rows[1].count = 0;
    for (int32_t y = view->top; y <= view->bottom; y++) {
        const struct row *above = &rows[(y + 1) % 2];
        struct row *row = &rows[y % 2];
        int32_t first = 0, start = 0, end = 0;
        row->count = 0;
        if (y < view->bottom)
            frob_match_row(image, y, view->left, view->right, colours, mask);
        while (y < view->bottom && frob_next_run(mask, view->right - view->left, &start, &end)) {
            const int32_t component = component_of(all, above, &first, start, end);
            const struct run run = { start, end, component };
            frob_add_run(&all->moments[component], y, view->left + start, view->left + end);
            row->runs[row->count++] = run;
        }
        for (int32_t i = 0; i < row->count; i++) {
            row->runs[i].component = whole(all, row->runs[i].component);
            all->last[row->runs[i].component] = y;
        }
        end_row(all, above, y);
    }
}

void frob_find_blobs(const struct frob_image *image, const struct frob_region *roi,
                     const struct frob_colour_range *colours, struct frob_blobs *result)
{
    const struct frob_view view = frob_view_of(image, roi);
    const struct frob_colours made = frob_colours_of(colours);
    struct components all;

    all.count = 0;
    for (int32_t i = 0; i < MOST; i++)
        all.free[i] = i;
    all.free_count = MOST;
    find(image, &view, &made, &all);
    memset(result, 0, sizeof *result);
    result->count = all.count;
    for (int32_t i = 0; i < all.count; i++)
        frob_blob_of(&all.largest[i], &result->largest[i]);
}
