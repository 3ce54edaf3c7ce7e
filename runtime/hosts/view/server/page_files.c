#include "page_files.h"

#include <string.h>

/* Defined in page_files.S. */
extern const char frob_page_html[], frob_page_html_end[];
extern const char frob_packed_html[], frob_packed_html_end[];
extern const char frob_page_css[], frob_page_css_end[];
extern const char frob_packed_css[], frob_packed_css_end[];
extern const char frob_page_icon[], frob_page_icon_end[];
extern const char frob_packed_icon[], frob_packed_icon_end[];
extern const char frob_page_js[], frob_page_js_end[];
extern const char frob_packed_js[], frob_packed_js_end[];
extern const char frob_page_licences[], frob_page_licences_end[];
extern const char frob_packed_licences[], frob_packed_licences_end[];

static const struct page_file files[] = {
    { "/", "text/html; charset=utf-8", frob_page_html, frob_page_html_end, frob_packed_html,
      frob_packed_html_end },
    { "/page.css", "text/css; charset=utf-8", frob_page_css, frob_page_css_end, frob_packed_css,
      frob_packed_css_end },
    { "/page.js", "text/javascript; charset=utf-8", frob_page_js, frob_page_js_end, frob_packed_js,
      frob_packed_js_end },
    { "/icon.svg", "image/svg+xml", frob_page_icon, frob_page_icon_end, frob_packed_icon,
      frob_packed_icon_end },
    { "/licences.txt", "text/plain; charset=utf-8", frob_page_licences, frob_page_licences_end,
      frob_packed_licences, frob_packed_licences_end },
};

const struct page_file *page_file(const char *path)
{
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++)
        if (strcmp(files[i].path, path) == 0)
            return &files[i];
    return NULL;
}

bool page_file_may_be_packed(const char *encodings, size_t length)
{
    static const char gzip[] = "gzip";
    for (size_t i = 0; i + sizeof gzip - 1 <= length; i++)
        if (memcmp(encodings + i, gzip, sizeof gzip - 1) == 0)
            return true;
    return false;
}
