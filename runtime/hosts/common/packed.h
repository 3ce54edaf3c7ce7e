/* packed.h -- recordings that are compressed: what is named .gz or .zst goes through `gzip` or
 * `zstd`, a process of its own.
 *
 * That process is deaf to what ends a run (Ctrl-C, SIGTERM, SIGHUP), and if this one is killed
 * it still writes to the end what it was given; so a recording is a whole archive whatever
 * becomes of the host. */
#ifndef FROB_HOST_PACKED_H
#define FROB_HOST_PACKED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>

/* What compresses a file of this name, "gzip" or "zstd"; NULL: nothing does. */
const char *packed_by(const char *name);

/* How long the name is without .gz or .zst. */
static inline size_t packed_stem(const char *name)
{
    const size_t length = strlen(name);
    if (length > 3 && strcmp(name + length - 3, ".gz") == 0)
        return length - 3;
    return length > 4 && strcmp(name + length - 4, ".zst") == 0 ? length - 4 : length;
}

/* In place of strerror, for files that are opened here. */
const char *packed_reason(const char *name, int error);

/* {1 Streams}, to be closed by fclose */

/* NULL with errno set. An archive that is cut off or damaged is an error of reading, after
 * all that comes out of it. */
FILE *packed_read(const char *name);

/* The file is written anew. NULL with errno set. */
FILE *packed_write(const char *name);

/* {1 Without a stream} for who decides what goes to the file at once */

struct packer {
    int file;      /* the file itself, or the way to the process; -1: none */
    pid_t process; /* 0: none */
    bool failed;
};

/* As fopen and fwrite without a buffer, and fclose. False with errno set; closing fails only if
 * nothing did before. */
bool packer_open(struct packer *packer, const char *name);
bool packer_put(struct packer *packer, const char *bytes, size_t size);
bool packer_close(struct packer *packer);

#endif
