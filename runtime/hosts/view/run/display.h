/* display.h -- what the program shows of an image, and draws on it: the marks `Picture` and
 * `InImage` of the library's module Display.
 *
 * An image that was shown stays until another is. Of the marks on it those of the last instant
 * count that showed an image or had such marks. So what is shown at an instant depends on all
 * before it, and goes along with the program's state. */
#ifndef FROB_VIEW_DISPLAY_H
#define FROB_VIEW_DISPLAY_H

#include "signals.h"

#define NO_INSTANT SIZE_MAX

/* After an instant. */
struct shown {
    size_t image; /* the instant that showed the image; or NO_INSTANT */
    int32_t key;  /* of the image (frob/lens.h) */
    size_t marks; /* the instant that drew the marks; or NO_INSTANT */
};

/* One element of what is drawn: an event of a mark. */
struct drawn {
    const struct signal *signal;
    const struct frob_value *mark;
};

struct display {
    struct drawn *drawn;
    size_t count;
    int picture, in_image; /* constructors of a mark; -1: the program has none such */
    struct shown shown;
    unsigned char *output; /* a copy of the output that has the marks … */
    size_t output_of;      /* … of this instant; or NO_INSTANT: it is not here */
    size_t size;
};

/* Of nothing that was shown yet. False without memory. */
bool display_start(struct display *display, const struct signals *signals);
void display_end(struct display *display);

/* The output of the next instant. */
void display_see(struct display *display, size_t k, const void *output);

/* Whether that element draws on the image, in an output. */
bool display_is_mark(const struct display *display, size_t element, const void *output);

#endif
