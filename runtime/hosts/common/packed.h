/* packed.h -- compressed recordings: files whose names end in .gz or .zst are piped through a
 * `gzip` or `zstd` process.
 *
 * When compressing, that process ignores the signals that end a run (Ctrl-C, SIGTERM, SIGHUP). If
 * the host is killed, the process still writes all data that it has received, so a recording is
 * always a complete archive. */
#ifndef FROB_HOST_PACKED_H
#define FROB_HOST_PACKED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>

/* Returns the tool that compresses a file of this name, "gzip" or "zstd"; NULL if the file is not
 * compressed. */
const char *packed_by(const char *name);

/* Returns the length of the name without .gz or .zst. */
static inline size_t packed_stem(const char *name)
{
    const size_t length = strlen(name);
    if (length > 3 && strcmp(name + length - 3, ".gz") == 0)
        return length - 3;
    return length > 4 && strcmp(name + length - 4, ".zst") == 0 ? length - 4 : length;
}

/* Replaces strerror for files that this module has opened. */
const char *packed_reason(const char *name, int error);

/* ---- Streams, which are closed with fclose */

/* Opens a file for reading. Returns NULL with errno set on failure. If an archive is truncated or
 * damaged, reading fails after all data that can be decompressed has been read. */
FILE *packed_read(const char *name);

/* Creates or overwrites a file. Returns NULL with errno set on failure. */
FILE *packed_write(const char *name);

/* ---- Without a stream, for callers that control when data is written */

struct packer {
    int file;      /* the file, or the socket to the process; -1: none */
    pid_t process; /* 0: no process */
    bool failed;
};

/* Like fopen, unbuffered fwrite, and fclose, but return false with errno set on failure. If an
 * earlier call has failed, packer_close returns true, so that callers report only the first
 * failure. */
bool packer_open(struct packer *packer, const char *name);
bool packer_put(struct packer *packer, const char *bytes, size_t size);
bool packer_close(struct packer *packer);

#endif
