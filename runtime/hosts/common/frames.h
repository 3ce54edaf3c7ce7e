/* frames.h -- the frames of a recording, in a folder next to it: LOG.frames for LOG.csv (and for
 * LOG.csv.gz, because the recording may be compressed later).
 *
 * Each frame is a file (<frob/frame.h>) named after its number and a part of its hash, so that the
 * frames of several cameras have different names: 000012-6c62272e07.ppm. The number and this part
 * together are its 64-bit key. */
#ifndef FROB_HOST_FRAMES_H
#define FROB_HOST_FRAMES_H

#include <frob/frame.h>
#include <frob/program.h>

#include <stdbool.h>

/* Returns whether a program's input contains images. */
bool frames_has_images(const struct frob_value *value);

uint64_t frames_key(const struct frob_frame_name *name);
uint32_t frames_number(uint64_t key);

/* ---- Writing */

struct frame_writer {
    char *folder; /* NULL: do not write frames */
    bool made;
};

/* Prepares to write the frames of this recording. Deletes the frames of an earlier recording with
 * this name. On failure returns false and prints a line on standard error. */
bool frame_writer_open(struct frame_writer *writer, const char *record);
bool frame_writer_put(struct frame_writer *writer, const struct frob_image *image);
void frame_writer_close(struct frame_writer *writer);

/* ---- Reading */

struct frame_reader {
    struct frob_frames finder; /* the image finder to pass to frob_cell_read */
    char *folder;
    bool verifies;       /* whether to verify the hash of each file */
    struct frame **each; /* hash table by key, with empty slots */
    size_t count, capacity;
    char expected[512];
};

/* Prepares to read the frames of this recording, without opening any file yet. Returns false if
 * memory runs out. The images that it finds stay valid until frame_reader_forget is called. */
bool frame_reader_open(struct frame_reader *reader, const char *record, bool verifies);

/* Returns the image with this key, or NULL if there is none. */
const struct frob_image *frame_reader_by_key(struct frame_reader *reader, uint64_t key);

/* Returns whether the contents of an image's file match the hash in its name. The image must have
 * been found by this reader. The hash is computed only once. */
bool frame_reader_is_unchanged(const struct frob_image *image);

void frame_reader_forget(struct frame_reader *reader);
void frame_reader_close(struct frame_reader *reader);

#endif
