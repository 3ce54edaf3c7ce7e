/* page_files.h -- the files of the page, which are embedded in the executable. */
#ifndef FROB_VIEW_PAGE_FILES_H
#define FROB_VIEW_PAGE_FILES_H

#include <stdbool.h>
#include <stddef.h>

struct page_file {
    const char *path; /* requested path: "/page.js" */
    const char *type; /* media type of its content */
    const char *begin, *end;
    const char *packed, *packed_end; /* compressed by gzip */
};

/* Returns whether a browser that sends this Accept-Encoding header accepts compressed files. */
bool page_file_may_be_packed(const char *encodings, size_t length);

/* Returns the file at a path; NULL if there is none. */
const struct page_file *page_file(const char *path);

#endif
