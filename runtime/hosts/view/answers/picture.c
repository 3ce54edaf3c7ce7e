#include "answers.h"

#include "../run/seen.h"

#include <stdlib.h>

/* Appends the pixels, in grey or colour, row by row. Each pixel is the mean of a square of `by` by
 * `by` image pixels. */
static void add_pixels(const struct frob_image *image, size_t columns, size_t rows, size_t by,
                       struct buffer *answer)
{
    const size_t depth = (size_t)frob_image_pixel_size(image->format), width = columns * depth;
    const unsigned count = (unsigned)(by * by);
    unsigned char *line;
    if (by == 1) {
        for (size_t y = 0; y < rows; y++)
            buffer_bytes(answer, (const char *)frob_image_row(image, (int32_t)y), width);
        return;
    }
    line = (unsigned char *)malloc(width + 1);
    if (line == NULL) {
        answer->failed = true;
        return;
    }
    for (size_t y = 0; y < rows; y++) {
        for (size_t x = 0; x < width; x++) {
            const size_t left = x / depth * by * depth + x % depth;
            unsigned sum = count / 2;
            for (size_t v = 0; v < by; v++) {
                const uint8_t *row = frob_image_row(image, (int32_t)(y * by + v)) + left;
                for (size_t u = 0; u < by; u++)
                    sum += row[u * depth];
            }
            line[x] = (unsigned char)(sum / count);
        }
        buffer_bytes(answer, (const char *)line, width);
    }
    free(line);
}

/* Appends the marks on the image, in the form of trace cells. */
static void add_marks(const struct view *view, const void *output, struct buffer *answer)
{
    const struct display *display = &view->replay.display;
    const struct moment moment = { NULL, output, output };
    bool is_first = true;
    buffer_text(answer, ",\"marks\":[");
    for (size_t i = 0; output != NULL && i < display->count; i++) {
        struct buffer cell = { 0 };
        if (!display_is_mark(display, i, output))
            continue;
        signal_write(&view->signals, display->drawn[i].signal, &moment, &cell);
        buffer_text(answer, is_first ? "" : ",");
        buffer_string(answer, cell.length > 0 ? cell.data : "");
        buffer_free(&cell);
        is_first = false;
    }
    buffer_text(answer, "]");
}

/* Reports, in place of the image, that this image or a newer one is missing or has changed. */
static void add_loss(const struct lost_frame *lost, struct buffer *answer)
{
    buffer_format(answer, ",\"lost\":{\"number\":%lu,\"k\":%lu,\"changed\":%s}",
                  (unsigned long)lost->number, (unsigned long)lost->k,
                  lost->is_there ? "true" : "false");
}

void answer_picture(struct view *view, size_t k, size_t width, size_t had, struct buffer *answer)
{
    const void *output;
    const struct shown shown = replay_shown(&view->replay, k, &output);
    const bool is_chosen = shown.image != NO_INSTANT;
    size_t at = is_chosen ? shown.image : k;
    const struct frob_image *image =
        seen_image(&view->recording, is_chosen ? &shown.key : NULL, &at);
    const struct lost_frame *lost = seen_lost(&view->recording, k);
    bool is_lost = lost != NULL && (image == NULL || lost->k >= at);
    struct lost_frame changed;
    if (image != NULL && !is_lost && !frame_reader_is_unchanged(image)) {
        changed.k = at;
        changed.number = image->number;
        changed.is_there = true;
        lost = &changed;
        is_lost = true;
    }
    answer->is_binary = true;
    buffer_format(answer, "{\"is\":\"picture\",\"k\":%lu,\"chosen\":%s", (unsigned long)k,
                  is_chosen ? "true" : "false");
    if (image != NULL && !is_lost) {
        const size_t by = ((size_t)image->width + width - 1) / width;
        const size_t columns = (size_t)image->width / by, rows = (size_t)image->height / by;
        const bool is_same = had == at + 1;
        buffer_format(answer, ",\"at\":%lu,\"number\":%lu,\"width\":%ld,\"height\":%ld,\"age\":",
                      (unsigned long)at, (unsigned long)image->number, (long)image->width,
                      (long)image->height);
        buffer_number(answer, (double)(view->recording.times[k] - image->captured_ns) / 1e9);
        add_marks(view, output, answer);
        if (is_same || image->format == FROB_DEPTH_M) {
            buffer_text(answer, "}\n");
            return;
        }
        buffer_format(answer, ",\"by\":%lu,\"columns\":%lu,\"rows\":%lu,\"grey\":%s}\n",
                      (unsigned long)by, (unsigned long)columns, (unsigned long)rows,
                      image->format == FROB_GREY8 ? "true" : "false");
        add_pixels(image, columns, rows, by, answer);
        return;
    }
    if (is_lost)
        add_loss(lost, answer);
    buffer_text(answer, "}\n");
}
