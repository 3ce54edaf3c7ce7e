#include "tag_finder.h"

#include "apriltag.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The library functions that are used. */
static struct {
    void *object;
    void *(*make_family)(void);
    void (*destroy_family)(void *);
    void *(*make_detector)(void);
    void (*destroy_detector)(void *);
    void (*add_family)(void *, void *, int);
    struct apriltag_array *(*detect)(void *, struct apriltag_image *);
    void (*destroy_found)(struct apriltag_array *);
} library;

/* ISO C does not allow converting a data pointer to a function pointer; POSIX does. */
static bool find(const char *name, void *function)
{
    void *address = dlsym(library.object, name);
    memcpy(function, &address, sizeof address);
    return address != NULL;
}

static bool load(void)
{
    if (library.object != NULL)
        return true;
    library.object = dlopen(APRILTAG_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    if (library.object == NULL) {
        fprintf(stderr,
                "error: this program detects tags, but the library " APRILTAG_LIBRARY
                " is not installed: install it (Debian: `sudo apt-get install libapriltag-dev`); "
                "replaying a recording does not need it\n");
        return false;
    }
    if (find("tag36h11_create", &library.make_family) &&
        find("tag36h11_destroy", &library.destroy_family) &&
        find("apriltag_detector_create", &library.make_detector) &&
        find("apriltag_detector_destroy", &library.destroy_detector) &&
        find("apriltag_detector_add_family_bits", &library.add_family) &&
        find("apriltag_detector_detect", &library.detect) &&
        find("apriltag_detections_destroy", &library.destroy_found))
        return true;
    fprintf(stderr,
            "error: " APRILTAG_LIBRARY " is not a supported version of the AprilTag library\n");
    dlclose(library.object);
    library.object = NULL;
    return false;
}

bool tag_finder_open(struct tag_finder *finder)
{
    struct apriltag_settings settings;
    memset(finder, 0, sizeof *finder);
    if (!load())
        return false;
    finder->family = library.make_family();
    finder->detector = library.make_detector();
    if (finder->family == NULL || finder->detector == NULL) {
        fprintf(stderr, "error: not enough memory to detect tags\n");
        return false;
    }
    memcpy(&settings, finder->detector, sizeof settings);
    settings.threads = 1;
    settings.decimate = 1.0f;
    memcpy(finder->detector, &settings, sizeof settings);
    library.add_family(finder->detector, finder->family, 1);
    return true;
}

void tag_finder_close(struct tag_finder *finder)
{
    if (finder->detector != NULL)
        library.destroy_detector(finder->detector);
    if (finder->family != NULL)
        library.destroy_family(finder->family);
    free(finder->grey);
    memset(finder, 0, sizeof *finder);
}

/* Sets the minimum contrast between a tag's white and black parts; the library ignores areas with
 * less contrast. With the default, 5, the library spends most of its time on noise. This function
 * uses a sixth of the contrast of the whole image, which is lower in a dark image, but at least
 * 5. */
static void set_contrast(struct tag_finder *finder, size_t size)
{
    struct apriltag_settings settings;
    uint8_t darkest = 255, lightest = 0;
    int contrast;
    for (size_t i = 0; i < size; i++) {
        const uint8_t p = finder->grey[i];
        darkest = p < darkest ? p : darkest;
        lightest = p > lightest ? p : lightest;
    }
    contrast = (lightest - darkest) / 6;
    memcpy(&settings, finder->detector, sizeof settings);
    settings.quads.least_contrast = contrast < 5 ? 5 : contrast;
    memcpy(finder->detector, &settings, sizeof settings);
}

/* Converts the image to grey, in rows without gaps, as the library requires. */
static bool make_grey(struct tag_finder *finder, const struct frob_image *image)
{
    const size_t size = (size_t)image->width * (size_t)image->height;
    uint8_t *to;
    if (size > finder->room) {
        uint8_t *more = (uint8_t *)realloc(finder->grey, size);
        if (more == NULL)
            return false;
        finder->grey = more;
        finder->room = size;
    }
    to = finder->grey;
    for (int32_t y = 0; y < image->height; y++) {
        const uint8_t *p = frob_image_row(image, y);
        if (image->format == FROB_GREY8)
            memcpy(to, p, (size_t)image->width);
        else
            for (int32_t x = 0; x < image->width; x++)
                to[x] =
                    (uint8_t)((77 * p[3 * x] + 150 * p[3 * x + 1] + 29 * p[3 * x + 2] + 128) / 256);
        to += image->width;
    }
    return true;
}

/* Returns twice the area of the quadrilateral. */
static double area(const struct frob_tag *tag)
{
    const struct frob_vec2 *p = tag->corners;
    return (p[2].x - p[0].x) * (p[1].y - p[3].y) - (p[2].y - p[0].y) * (p[1].x - p[3].x);
}

static bool comes_before(const struct frob_tag *one, const struct frob_tag *other)
{
    const double a = area(one), b = area(other);
    return a > b || (a >= b && one->id < other->id);
}

/* Inserts a tag into the sorted list. If there are too many tags, drops the last one. */
static void insert(struct frob_tags *tags, const struct frob_tag *tag)
{
    size_t at = tags->count;
    while (at > 0 && comes_before(tag, &tags->each[at - 1]))
        at--;
    if (at == FROB_MOST_TAGS)
        return;
    if (tags->count < FROB_MOST_TAGS)
        tags->count++;
    memmove(&tags->each[at + 1], &tags->each[at], (tags->count - at - 1) * sizeof *tag);
    tags->each[at] = *tag;
}

bool tag_finder_find(struct tag_finder *finder, const struct frob_image *image,
                     struct frob_tags *tags)
{
    struct apriltag_image seen = { image->width, image->height, image->width, NULL };
    struct apriltag_array *found;
    memset(tags, 0, sizeof *tags);
    if (!frob_image_is_sound(image) || image->format == FROB_DEPTH_M || image->width < 8 ||
        image->height < 8)
        return true;
    if (!make_grey(finder, image)) {
        fprintf(stderr, "error: not enough memory to detect tags\n");
        return false;
    }
    set_contrast(finder, (size_t)image->width * (size_t)image->height);
    seen.pixels = finder->grey;
    found = library.detect(finder->detector, &seen);
    for (int i = 0; found != NULL && i < found->count; i++) {
        const struct apriltag_found *one;
        struct frob_tag tag;
        memcpy(&one, found->elements + (size_t)i * found->element_size, sizeof one);
        tag.id = one->id;
        tag.middle.x = one->middle[0] - 0.5;
        tag.middle.y = one->middle[1] - 0.5;
        for (int k = 0; k < 4; k++) {
            tag.corners[k].x = one->corners[k][0] - 0.5;
            tag.corners[k].y = one->corners[k][1] - 0.5;
        }
        tag.margin = (double)one->margin;
        insert(tags, &tag);
    }
    if (found != NULL)
        library.destroy_found(found);
    return true;
}
