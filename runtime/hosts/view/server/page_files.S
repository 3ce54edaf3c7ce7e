/* Embeds the files of the page in the executable, each as it is and compressed. */
#define BYTES(label, path)   \
    .global label;           \
    .global label##_end;     \
    label:                   \
    .incbin path;            \
    label##_end:
#define FILE(name, path, packed)    \
    BYTES(frob_page_##name, path)   \
    BYTES(frob_packed_##name, packed)

    .section .rodata
FILE(html, "hosts/view/page/bundle/page.html", "page.html.gz")
FILE(css, "hosts/view/page/bundle/page.css", "page.css.gz")
FILE(js, "hosts/view/page/bundle/page.js", "page.js.gz")
FILE(icon, "hosts/view/page/bundle/icon.svg", "icon.svg.gz")
FILE(licences, "hosts/view/page/bundle/licences.txt", "licences.txt.gz")

    .section .note.GNU-stack,"",%progbits
