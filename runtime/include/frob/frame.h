/* frob/frame.h -- a frame of a camera as a file, and as the cell of a trace.
 *
 * The file is netpbm's: PGM of grey pixels, PPM of colours; frames of depths have none.
 * Comments in its head have what else a struct frob_image says, with all digits, so what is
 * read is what was written, bit for bit:
 *
 *   P6
 *   # frob frame 12 captured_ns 400000000
 *   # camera FOCAL_X FOCAL_Y CENTRE_X CENTRE_Y K1 K2 K3 P1 P2
 *   # seat X_M Y_M Z_M YAW_RAD PITCH_RAD ROLL_RAD
 *   320 240
 *   255
 *
 * A cell names a file: `Image 12 230583 0x6c62272e07bb0142`, the frame's number, the file's
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

/* What a cell says. */
struct frob_frame_name {
    uint32_t number;
    uint64_t size;
    uint64_t hash;
};

struct frob_frame_name frob_frame_name_of(const struct frob_image *image);

/* Room for the head of any file, with the NUL. */
#define FROB_FRAME_HEAD_ROOM 1024

/* Writes the head, all that comes before the pixels, and returns its length. The rows follow
 * it without anything between them. */
size_t frob_frame_head(const struct frob_image *image, char head[FROB_FRAME_HEAD_ROOM]);

/* Fills in the image from a file of `size` bytes in memory, where its pixels stay. NULL, or
 * what is wrong with the file: a static text about "it". */
const char *frob_frame_read(const void *file, size_t size, struct frob_image *image);

/* Who has frames, for cells that name them: an image that is good until the instant is over,
 * or NULL and a text on why there is none, which goes on after "expected". */
struct frob_frames {
    const struct frob_image *(*find)(void *context, const struct frob_frame_name *name,
                                     const char **expected);
    void *context;
};

#ifdef __cplusplus
}
#endif
#endif
