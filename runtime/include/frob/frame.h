/* frob/frame.h -- stores a camera frame in a file, and refers to it by name in a cell of a trace.
 *
 * The file is in a netpbm format: PGM for grey pixels, PPM for colours. Depth images have no file
 * format. Comments in the header store the other members of struct frob_image with all their
 * digits, so reading a file restores the frame bit for bit:
 *
 *   P6
 *   # frob frame 12 captured_ns 400000000
 *   # camera FOCAL_X FOCAL_Y CENTRE_X CENTRE_Y K1 K2 K3 P1 P2
 *   # seat X_M Y_M Z_M YAW_RAD PITCH_RAD ROLL_RAD
 *   320 240
 *   255
 *
 * A cell names a file: `Image 12 230583 0x6c62272e07bb0142` contains the frame's number, the file's
 * size in bytes, and a hash of its contents. */
#ifndef FROB_FRAME_H
#define FROB_FRAME_H

#include <frob/image.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The contents of a cell that names a frame. */
struct frob_frame_name {
    uint32_t number;
    uint64_t size;
    uint64_t hash;
};

struct frob_frame_name frob_frame_name_of(const struct frob_image *image);

/* Size of a buffer that is large enough for the header of any file, with the NUL. */
#define FROB_FRAME_HEAD_ROOM 1024

/* Writes the header, which is everything before the pixels, and returns its length. The rows of
 * pixels follow it without gaps. */
size_t frob_frame_head(const struct frob_image *image, char head[FROB_FRAME_HEAD_ROOM]);

/* Fills in the image from a file of `size` bytes in memory. The image's pixels point into that
 * memory. Returns NULL on success, and otherwise a static error message that calls the file
 * "it". */
const char *frob_frame_read(const void *file, size_t size, struct frob_image *image);

/* Looks up the frames that cells refer to. `find` returns an image that is valid until the end of
 * the instant. If there is none, it returns NULL and sets `expected` to the words that follow
 * "expected" in the error message. */
struct frob_frames {
    const struct frob_image *(*find)(void *context, const struct frob_frame_name *name,
                                     const char **expected);
    void *context;
};

#ifdef __cplusplus
}
#endif
#endif
