#include "kept.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Maximum size of a file. A larger file does not come from a page. */
#define MOST 65536

/* The FNV-1a hash of the path of the program's file. */
static uint64_t number_of(const char *path)
{
    uint64_t number = 14695981039346656037U;
    for (; *path != '\0'; path++)
        number = (number ^ (unsigned char)*path) * 1099511628211U;
    return number;
}

/* Stores in `path` the path of the file for a program. If `creates` is true, also creates the
 * file's folders. Returns false if the program's file does not exist or the environment does not
 * name a folder. */
static bool find(const char *source, bool creates, char *path, size_t size)
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    char *whole = source == NULL ? NULL : realpath(source, NULL);
    int length = -1;
    if (whole != NULL && state != NULL && state[0] == '/')
        length = snprintf(path, size, "%s/frobc/view/%016llx.json", state,
                          (unsigned long long)number_of(whole));
    else if (whole != NULL && home != NULL && home[0] == '/')
        length = snprintf(path, size, "%s/.local/state/frobc/view/%016llx.json", home,
                          (unsigned long long)number_of(whole));
    free(whole);
    if (length < 0 || (size_t)length >= size)
        return false;
    for (char *slash = strchr(path + 1, '/'); creates && slash != NULL;
         slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(path, 0700) != 0 && errno != EEXIST)
            creates = false;
        *slash = '/';
    }
    return true;
}

void kept_read(const char *source, struct buffer *text)
{
    char path[4096], block[4096];
    size_t length;
    FILE *file;
    if (!find(source, false, path, sizeof path) || (file = fopen(path, "rb")) == NULL)
        return;
    while ((length = fread(block, 1, sizeof block, file)) > 0 && text->length + length <= MOST)
        buffer_bytes(text, block, length);
    if (length > 0 || ferror(file))
        buffer_clear(text);
    fclose(file);
}

void kept_write(const char *source, const char *text)
{
    char path[4096], new[4096 + 16];
    FILE *file;
    bool is_written;
    if (!find(source, true, path, sizeof path))
        return;
    /* Write to a temporary file first, because another viewer may write the file at the same
     * time. */
    snprintf(new, sizeof new, "%s.%ld", path, (long)getpid());
    file = fopen(new, "wb");
    if (file == NULL)
        return;
    is_written = fputs(text, file) >= 0;
    is_written = fclose(file) == 0 && is_written;
    if (!is_written || rename(new, path) != 0)
        remove(new);
}
