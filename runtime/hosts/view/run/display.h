/* display.h -- finds the image that the program shows, and the marks that it draws on the image:
 * `Picture` and `InImage` of the library's module Display.
 *
 * An image stays visible until another one is shown. The marks on it are those of the last instant
 * that showed an image or had such marks. Therefore the display at an instant depends on all
 * earlier instants, and is stored together with the program's state. */
#ifndef FROB_VIEW_DISPLAY_H
#define FROB_VIEW_DISPLAY_H

#include "signals.h"

#define NO_INSTANT SIZE_MAX

/* The display after an instant. */
struct shown {
    size_t image; /* instant at which the image was shown, or NO_INSTANT */
    int32_t key;  /* key of the image (frob/lens.h) */
    size_t marks; /* instant at which the marks were drawn, or NO_INSTANT */
};

/* One element of the drawing: an event that contains a mark. */
struct drawn {
    const struct signal *signal;
    const struct frob_value *mark;
};

struct display {
    struct drawn *drawn;
    size_t count;
    int picture, in_image; /* constructors of a mark; -1 if the program does not have them */
    struct shown shown;
    unsigned char *output; /* a copy of the output that contains the marks */
    size_t output_of;      /* instant of this copy; NO_INSTANT if there is none */
    size_t size;
};

/* Initializes the display with nothing shown. Returns false if memory runs out. */
bool display_start(struct display *display, const struct signals *signals);
void display_end(struct display *display);

/* Updates the display with the output of the next instant. */
void display_see(struct display *display, size_t k, const void *output);

/* Returns whether, in this output, this element of the drawing is a mark on the image. */
bool display_is_mark(const struct display *display, size_t element, const void *output);

#endif
