/* Writes small images of all kinds as the frames of a recording, and provides the vision kernels
 * to programs that tcc compiles. */
#include "frames_stubs.h"

#include <frob/lens.h>
#include <frob/vision.h>

#include <stdlib.h>
#include <string.h>

#define CAML_NAME_SPACE
#include <caml/alloc.h>
#include <caml/fail.h>
#include <caml/memory.h>

static struct frame_reader reader;
static bool is_open;

const struct frob_frames *frames_of_fuzz(void)
{
    return is_open ? &reader.finder : NULL;
}

struct size {
    int32_t width, height;
    enum frob_image_format format;
};

static const struct size sizes[] = {
    { 32, 24, FROB_RGB8 }, { 40, 40, FROB_GREY8 }, { 64, 20, FROB_RGB8 }, { 7, 9, FROB_GREY8 },
    { 1, 1, FROB_RGB8 },   { 90, 12, FROB_GREY8 }, { 48, 48, FROB_RGB8 }, { 32, 24, FROB_GREY8 },
};
enum { COUNT = sizeof sizes / sizeof sizes[0] };

/* Draws a bright square, a coloured disc, and noise. */
static void draw(uint8_t *pixels, const struct size *size, uint32_t seed)
{
    const int bytes = frob_image_pixel_size(size->format);
    for (int32_t y = 0; y < size->height; y++)
        for (int32_t x = 0; x < size->width; x++)
            for (int k = 0; k < bytes; k++) {
                const int32_t dx = x - size->width / 2, dy = y - size->height / 2;
                const bool in_square = x > 3 && x < 12 && y > 4 && y < 12;
                const bool in_disc = dx * dx + dy * dy < 30;
                seed = seed * 1664525u + 1013904223u;
                *pixels++ = (uint8_t)((in_square ? 200
                                       : in_disc ? 60 + 70 * (int)k
                                                 : 90 + x % 7) +
                                      (int)(seed >> 28));
            }
}

static struct frob_image image_of(uint32_t k, const uint8_t *pixels)
{
    struct frob_image image;
    memset(&image, 0, sizeof image);
    image.width = sizes[k].width;
    image.height = sizes[k].height;
    image.format = sizes[k].format;
    image.stride = image.width * frob_image_pixel_size(image.format);
    image.pixels = pixels;
    image.captured_ns = 1000000 * (int64_t)k;
    image.number = k;
    image.camera.focal_x = image.camera.focal_y = 30;
    image.camera.centre_x = 15;
    image.camera.centre_y = 12;
    image.camera.k1 = k % 2 == 0 ? 0 : -0.2;
    image.camera.y_m = 0.05 * k;
    return image;
}

/* frames_write : string -> (int * int64 * int64) array -- writes the frames of this recording;
 * returns their numbers, sizes and hashes. */
value frames_write(value record)
{
    CAMLparam1(record);
    CAMLlocal3(all, one, number);
    struct frame_writer writer;
    bool ok;
    if (is_open)
        frame_reader_close(&reader);
    ok = frame_writer_open(&writer, String_val(record));
    all = caml_alloc(COUNT, 0);
    for (uint32_t k = 0; ok && k < COUNT; k++) {
        static uint8_t pixels[3 * 128 * 128];
        struct frob_image image = image_of(k, pixels);
        const struct frob_frame_name name =
            (draw(pixels, &sizes[k], k), frob_frame_name_of(&image));
        ok = frame_writer_put(&writer, &image);
        one = caml_alloc_tuple(3);
        Store_field(one, 0, Val_long((long)name.number));
        number = caml_copy_int64((int64_t)name.size);
        Store_field(one, 1, number);
        number = caml_copy_int64((int64_t)name.hash);
        Store_field(one, 2, number);
        Store_field(all, k, one);
    }
    frame_writer_close(&writer);
    is_open = ok && frame_reader_open(&reader, String_val(record), true);
    if (!is_open)
        caml_failwith("the frames cannot be written");
    CAMLreturn(all);
}

void frames_add_kernels(TCCState *compiler)
{
#define ADD(name) tcc_add_symbol(compiler, #name, (const void *)(intptr_t)name)
    ADD(frob_image_lens);
    ADD(frob_find_blob);
    ADD(frob_find_blobs);
    ADD(frob_get_statistics);
    ADD(frob_get_histogram);
    ADD(frob_find_edges);
    ADD(frob_find_corner);
    ADD(frob_get_patch);
    ADD(frob_match_patch);
    ADD(frob_find_template);
    ADD(frob_undistort_point);
    ADD(frob_distort_point);
    ADD(frob_stereo_depths);
#undef ADD
}
