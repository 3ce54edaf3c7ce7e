/* Embeds the files of the page in the executable. */
#define FILE(name, path)   \
    .global frob_page_##name;      \
    .global frob_page_##name##_end; \
    frob_page_##name:              \
    .incbin path;                  \
    frob_page_##name##_end:

    .section .rodata
FILE(html, "hosts/view/page/bundle/page.html")
FILE(css, "hosts/view/page/bundle/page.css")
FILE(js, "hosts/view/page/bundle/page.js")
FILE(icon, "hosts/view/page/bundle/icon.svg")
FILE(licences, "hosts/view/page/bundle/licences.txt")

    .section .note.GNU-stack,"",%progbits
