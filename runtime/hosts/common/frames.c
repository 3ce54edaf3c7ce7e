#include "frames.h"

#include "packed.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

enum { KEY_NUMBER_BITS = 24, NAME_ROOM = 32 };

bool frames_has_images(const struct frob_value *value)
{
    if (value->kind == FROB_IMAGE)
        return true;
    if (value->kind != FROB_SUM && value->kind != FROB_PRODUCT && value->kind != FROB_ARRAY)
        return false;
    for (size_t i = 0; i < value->count; i++)
        for (size_t j = 0; j < value->constructors[i].count; j++)
            if (frames_has_images(value->constructors[i].fields[j].value))
                return true;
    return false;
}

uint64_t frames_key(const struct frob_frame_name *name)
{
    return (uint64_t)name->number << (64 - KEY_NUMBER_BITS) | name->hash >> KEY_NUMBER_BITS;
}

uint32_t frames_number(uint64_t key)
{
    return (uint32_t)(key >> (64 - KEY_NUMBER_BITS));
}

/* Returns LOG.frames for both LOG.csv and LOG.csv.gz; NULL if memory runs out. */
static char *folder_of(const char *record)
{
    static const char suffix[] = ".frames";
    size_t length = packed_stem(record);
    char *folder = (char *)malloc(length + sizeof suffix);
    if (folder == NULL)
        return NULL;
    if (length > 4 && strncmp(record + length - 4, ".csv", 4) == 0)
        length -= 4;
    memcpy(folder, record, length);
    memcpy(folder + length, suffix, sizeof suffix);
    return folder;
}

/* Returns FOLDER/000012-6c62272e07.ppm; NULL if memory runs out. */
static char *path_of(const char *folder, uint64_t key, bool grey)
{
    const size_t room = strlen(folder) + NAME_ROOM;
    char *path = (char *)malloc(room);
    if (path != NULL)
        snprintf(path, room, "%s/%06" PRIu64 "-%010" PRIx64 "%s", folder,
                 key >> (64 - KEY_NUMBER_BITS), key & ((UINT64_C(1) << (64 - KEY_NUMBER_BITS)) - 1),
                 grey ? ".pgm" : ".ppm");
    return path;
}

/* ---- Writing */

static bool cannot(const char *what, const char *path)
{
    fprintf(stderr, "error: cannot %s %s: %s\n", what, path == NULL ? "frames" : path,
            strerror(errno));
    return false;
}

static bool is_frame_name(const char *name)
{
    const size_t digits = strspn(name, "0123456789");
    return digits >= 6 && name[digits] == '-' &&
           strspn(name + digits + 1, "0123456789abcdef") == 10 &&
           (strcmp(name + digits + 11, ".ppm") == 0 || strcmp(name + digits + 11, ".pgm") == 0);
}

/* Removes the frames. Keeps the folder, and files that are not frames. */
static bool remove_old(const char *folder)
{
    DIR *listing = opendir(folder);
    bool ok = true;
    if (listing == NULL)
        return errno == ENOENT || cannot("read", folder);
    for (struct dirent *entry; ok && (entry = readdir(listing)) != NULL;)
        if (is_frame_name(entry->d_name) && unlinkat(dirfd(listing), entry->d_name, 0) != 0)
            ok = cannot("remove an old frame in", folder);
    closedir(listing);
    return ok;
}

bool frame_writer_open(struct frame_writer *writer, const char *record)
{
    memset(writer, 0, sizeof *writer);
    if (record == NULL)
        return true;
    writer->folder = folder_of(record);
    return writer->folder == NULL ? cannot("write", NULL) : remove_old(writer->folder);
}

static bool write_all(int file, const void *bytes, size_t size)
{
    const char *at = (const char *)bytes;
    while (size > 0) {
        const ssize_t written = write(file, at, size);
        if (written < 0 && errno != EINTR)
            return false;
        at += written < 0 ? 0 : written;
        size -= written < 0 ? 0 : (size_t)written;
    }
    return true;
}

static bool write_file(const char *path, const struct frob_image *image)
{
    char head[FROB_FRAME_HEAD_ROOM];
    const size_t length = frob_frame_head(image, head);
    const size_t row = (size_t)image->width * (size_t)frob_image_pixel_size(image->format);
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    bool ok = file >= 0 && write_all(file, head, length);
    if (ok && (size_t)image->stride == row)
        ok = write_all(file, image->pixels, row * (size_t)image->height);
    else
        for (int32_t y = 0; ok && y < image->height; y++)
            ok = write_all(file, frob_image_row(image, y), row);
    if (file >= 0 && close(file) != 0)
        ok = false;
    return ok || cannot("write", path);
}

bool frame_writer_put(struct frame_writer *writer, const struct frob_image *image)
{
    struct frob_frame_name name;
    char *path;
    bool ok;
    if (writer->folder == NULL)
        return true;
    if (!writer->made && mkdir(writer->folder, 0777) != 0 && errno != EEXIST)
        return cannot("create the folder", writer->folder);
    writer->made = true;
    name = frob_frame_name_of(image);
    path = path_of(writer->folder, frames_key(&name), image->format == FROB_GREY8);
    ok = path != NULL ? write_file(path, image) : cannot("write", NULL);
    free(path);
    return ok;
}

void frame_writer_close(struct frame_writer *writer)
{
    free(writer->folder);
    writer->folder = NULL;
}

/* ---- Reading */

struct frame {
    uint64_t key;
    struct frob_image image; /* the image's pixels point into the file's contents */
    void *file;
    size_t size;
    bool is_checked, is_unchanged;
};

bool frame_reader_is_unchanged(const struct frob_image *image)
{
    struct frame *frame =
        (struct frame *)(void *)((char *)(uintptr_t)image - offsetof(struct frame, image));
    if (!frame->is_checked) {
        const struct frob_frame_name name = frob_frame_name_of(image);
        frame->is_checked = true;
        frame->is_unchanged = frames_key(&name) == frame->key;
    }
    return frame->is_unchanged;
}

/* Returns the slot that contains a key, or the empty slot in which to insert it. */
static size_t slot_of(const struct frame_reader *reader, uint64_t key)
{
    size_t slot = (size_t)(key * UINT64_C(0x9e3779b97f4a7c15) >> 20) & (reader->capacity - 1);
    while (reader->each[slot] != NULL && reader->each[slot]->key != key)
        slot = (slot + 1) & (reader->capacity - 1);
    return slot;
}

/* Grows the table so that at least half of the slots remain empty. */
static bool grow(struct frame_reader *reader)
{
    struct frame **before = reader->each;
    const size_t count = reader->capacity;
    if (2 * (reader->count + 1) <= reader->capacity)
        return true;
    reader->capacity = count == 0 ? 16 : 2 * count;
    reader->each = (struct frame **)calloc(reader->capacity, sizeof *reader->each);
    if (reader->each == NULL) {
        reader->each = before;
        reader->capacity = count;
        return false;
    }
    for (size_t i = 0; i < count; i++)
        if (before[i] != NULL)
            reader->each[slot_of(reader, before[i]->key)] = before[i];
    free(before);
    return true;
}

static const struct frob_image *wrong(struct frame_reader *reader, const char *path,
                                      const char *what)
{
    snprintf(reader->expected, sizeof reader->expected, "an existing frame (%s: %s)", path, what);
    return NULL;
}

/* Adds a frame. On failure, returns NULL and stores what was expected, for an error message. */
static const struct frob_image *add(struct frame_reader *reader, uint64_t key, const char *path,
                                    int file)
{
    struct stat status;
    struct frame *frame;
    const char *fault;
    void *bytes;
    if (fstat(file, &status) != 0 || !grow(reader))
        return wrong(reader, path, "it cannot be read");
    if (status.st_size <= 0)
        return wrong(reader, path, "it is empty");
    bytes = mmap(NULL, (size_t)status.st_size, PROT_READ, MAP_PRIVATE, file, 0);
    frame = (struct frame *)calloc(1, sizeof *frame);
    if (bytes == MAP_FAILED || frame == NULL) {
        if (bytes != MAP_FAILED)
            munmap(bytes, (size_t)status.st_size);
        free(frame);
        return wrong(reader, path, "there is not enough memory for it");
    }
    frame->key = key;
    frame->file = bytes;
    frame->size = (size_t)status.st_size;
    fault = frob_frame_read(bytes, frame->size, &frame->image);
    if (fault != NULL) {
        munmap(bytes, frame->size);
        free(frame);
        return wrong(reader, path, fault);
    }
    reader->each[slot_of(reader, key)] = frame;
    reader->count++;
    return &frame->image;
}

const struct frob_image *frame_reader_by_key(struct frame_reader *reader, uint64_t key)
{
    const struct frob_image *image = NULL;
    if (reader->capacity > 0 && reader->each[slot_of(reader, key)] != NULL)
        return &reader->each[slot_of(reader, key)]->image;
    wrong(reader, reader->folder, "it cannot be read");
    for (int grey = 0; grey < 2 && image == NULL; grey++) {
        char *path = path_of(reader->folder, key, grey);
        const int file = path == NULL ? -1 : open(path, O_RDONLY | O_CLOEXEC);
        if (file >= 0) {
            image = add(reader, key, path, file);
            close(file);
            free(path);
            return image;
        }
        if (path != NULL && grey == 0)
            wrong(reader, path, strerror(errno));
        free(path);
    }
    return image;
}

static const struct frob_image *find(void *context, const struct frob_frame_name *name,
                                     const char **expected)
{
    struct frame_reader *reader = (struct frame_reader *)context;
    const struct frob_image *image = frame_reader_by_key(reader, frames_key(name));
    *expected = reader->expected;
    if (image != NULL && reader->verifies) {
        const struct frob_frame_name found = frob_frame_name_of(image);
        if (found.hash != name->hash || found.size != name->size) {
            *expected = "the recorded frame (its file was changed)";
            return NULL;
        }
    }
    return image;
}

bool frame_reader_open(struct frame_reader *reader, const char *record, bool verifies)
{
    memset(reader, 0, sizeof *reader);
    reader->folder = folder_of(record);
    reader->verifies = verifies;
    reader->finder.find = find;
    reader->finder.context = reader;
    return reader->folder != NULL;
}

void frame_reader_forget(struct frame_reader *reader)
{
    for (size_t i = 0; i < reader->capacity && reader->count > 0; i++) {
        if (reader->each[i] != NULL) {
            munmap(reader->each[i]->file, reader->each[i]->size);
            free(reader->each[i]);
            reader->each[i] = NULL;
        }
    }
    reader->count = 0;
}

void frame_reader_close(struct frame_reader *reader)
{
    frame_reader_forget(reader);
    free(reader->each);
    free(reader->folder);
    memset(reader, 0, sizeof *reader);
}
