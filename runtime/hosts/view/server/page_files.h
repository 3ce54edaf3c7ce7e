/* page_files.h -- the files of the page, which are embedded in the executable. */
#ifndef FROB_VIEW_PAGE_FILES_H
#define FROB_VIEW_PAGE_FILES_H

#include <stddef.h>

struct page_file {
    const char *path; /* requested path: "/page.js" */
    const char *type; /* media type of its content */
    const char *begin, *end;
};

/* Returns the file at a path; NULL if there is none. */
const struct page_file *page_file(const char *path);

#endif
