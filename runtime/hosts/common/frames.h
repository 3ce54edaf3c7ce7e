/* frames.h -- the frames of a recording, in a folder beside it: LOG.frames for LOG.csv
 * (and for LOG.csv.gz: it may be compressed later).
 *
 * Each is a file of its own (<frob/frame.h>), named by its number and by a part of its hash, so
 * that frames of several cameras have room beside each other: 000012-6c62272e07.ppm. Number and
 * part together are its key, 64 bits. */
#ifndef FROB_HOST_FRAMES_H
#define FROB_HOST_FRAMES_H

#include <frob/frame.h>
#include <frob/program.h>

#include <stdbool.h>

/* Whether a program's input has images in it. */
bool frames_has_images(const struct frob_value *value);

uint64_t frames_key(const struct frob_frame_name *name);
uint32_t frames_number(uint64_t key);

/* {1 Writing} */

struct frame_writer {
    char *folder; /* NULL: nothing is written */
    bool made;
};

/* For the frames of this recording. Those that are there of a recording of the same name go: it
 * is being written anew. False with a line on standard error. */
bool frame_writer_open(struct frame_writer *writer, const char *record);
bool frame_writer_put(struct frame_writer *writer, const struct frob_image *image);
void frame_writer_close(struct frame_writer *writer);

/* {1 Reading} */

struct frame_reader {
    struct frob_frames finder; /* for frob_cell_read */
    char *folder;
    bool verifies;       /* each file's hash too */
    struct frame **each; /* by key, with gaps */
    size_t count, capacity;
    char expected[512];
};

/* For the frames of this recording; nothing is opened yet. False without memory. Images that
 * are found stay until they are forgotten. */
bool frame_reader_open(struct frame_reader *reader, const char *record, bool verifies);

/* By its key; NULL if it is not there. */
const struct frob_image *frame_reader_by_key(struct frame_reader *reader, uint64_t key);

/* Whether the file of an image that was found has the contents that its name says; its pixels are
 * looked at once. */
bool frame_reader_is_unchanged(const struct frob_image *image);

void frame_reader_forget(struct frame_reader *reader);
void frame_reader_close(struct frame_reader *reader);

#endif
