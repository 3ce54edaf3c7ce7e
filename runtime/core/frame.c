#include <frob/frame.h>

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Writing */

size_t frob_frame_head(const struct frob_image *image, char head[FROB_FRAME_HEAD_ROOM])
{
    const struct frob_camera *c = &image->camera;
    const int length = snprintf(
        head, FROB_FRAME_HEAD_ROOM,
        "%s\n# frob frame %" PRIu32 " captured_ns %lld"
        "\n# camera %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
        "\n# seat %.17g %.17g %.17g %.17g %.17g %.17g\n%" PRId32 " %" PRId32 "\n255\n",
        image->format == FROB_GREY8 ? "P5" : "P6", image->number, (long long)image->captured_ns,
        c->focal_x, c->focal_y, c->centre_x, c->centre_y, c->k1, c->k2, c->k3, c->p1, c->p2, c->x_m,
        c->y_m, c->z_m, c->yaw_rad, c->pitch_rad, c->roll_rad, image->width, image->height);
    return (size_t)length;
}

static size_t row_size(const struct frob_image *image)
{
    return (size_t)image->width * (size_t)frob_image_pixel_size(image->format);
}

/* Hashes a piece of data, eight bytes at a time, as if it were padded with zeros. Each step applies
 * FNV-1a to a 64-bit word, and then folds the high bits into the low ones. */
static uint64_t hash_piece(uint64_t hash, const void *piece, size_t size)
{
    const unsigned char *bytes = (const unsigned char *)piece;
    for (size_t at = 0; at < size; at += 8) {
        unsigned char word[8] = { 0 };
        uint64_t x = 0;
        memcpy(word, bytes + at, size - at < 8 ? size - at : 8);
        for (int i = 7; i >= 0; i--)
            x = x << 8 | word[i];
        hash = (hash ^ x) * UINT64_C(0x100000001b3);
        hash ^= hash >> 29;
    }
    return hash;
}

static uint64_t hash_file(const char *head, size_t length, const struct frob_image *image)
{
    uint64_t hash = hash_piece(UINT64_C(0xcbf29ce484222325), head, length);
    for (int32_t y = 0; y < image->height; y++)
        hash = hash_piece(hash, frob_image_row(image, y), row_size(image));
    return hash;
}

struct frob_frame_name frob_frame_name_of(const struct frob_image *image)
{
    char head[FROB_FRAME_HEAD_ROOM];
    const size_t length = frob_frame_head(image, head);
    const struct frob_frame_name name = { image->number,
                                          length + row_size(image) * (size_t)image->height,
                                          hash_file(head, length, image) };
    return name;
}

/* ---- Reading */

struct head {
    const char *at, *end;
};

/* Copies the next line without its line feed. Returns NULL at the end, or if the line is too
 * long. */
static const char *next_line(struct head *h, char line[512])
{
    const size_t left = (size_t)(h->end - h->at);
    const char *feed = left > 0 ? (const char *)memchr(h->at, '\n', left) : NULL;
    const size_t length = feed == NULL ? 0 : (size_t)(feed - h->at);
    if (feed == NULL || length >= 512)
        return NULL;
    memcpy(line, h->at, length);
    line[length] = '\0';
    h->at = feed + 1;
    return line;
}

static bool numbers(const char *text, double *const *places, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char *end;
        *places[i] = strtod(text, &end);
        if (end == text)
            return false;
        text = end;
    }
    return *text == '\0';
}

/* Reads a comment if it is of a kind that frob_frame_head writes; otherwise ignores it. Returns
 * false if the comment is malformed. */
static bool read_comment(const char *line, struct frob_image *image)
{
    struct frob_camera *c = &image->camera;
    double *const camera[] = { &c->focal_x, &c->focal_y, &c->centre_x, &c->centre_y, &c->k1,
                               &c->k2,      &c->k3,      &c->p1,       &c->p2 };
    double *const seat[] = { &c->x_m, &c->y_m, &c->z_m, &c->yaw_rad, &c->pitch_rad, &c->roll_rad };
    if (strncmp(line, "# camera ", 9) == 0)
        return numbers(line + 9, camera, sizeof camera / sizeof camera[0]);
    if (strncmp(line, "# seat ", 7) == 0)
        return numbers(line + 7, seat, sizeof seat / sizeof seat[0]);
    if (strncmp(line, "# frob frame ", 13) == 0) {
        /* Not SCNd64, because newlib may lack it; see cell_write.c. */
        long long captured_ns = 0;
        if (sscanf(line + 13, "%" SCNu32 " captured_ns %lld", &image->number, &captured_ns) != 2)
            return false;
        image->captured_ns = captured_ns;
    }
    return true;
}

const char *frob_frame_read(const void *file, size_t size, struct frob_image *image)
{
    static const char broken[] = "it is not a frame written by frobc";
    struct head h = { (const char *)file, (const char *)file + size };
    char line[512];
    int most = 0;
    memset(image, 0, sizeof *image);
    if (next_line(&h, line) == NULL || (strcmp(line, "P5") != 0 && strcmp(line, "P6") != 0))
        return broken;
    image->format = line[1] == '5' ? FROB_GREY8 : FROB_RGB8;
    do {
        if (next_line(&h, line) == NULL || !read_comment(line, image))
            return broken;
    } while (line[0] == '#');
    if (sscanf(line, "%" SCNd32 " %" SCNd32, &image->width, &image->height) != 2 ||
        next_line(&h, line) == NULL || sscanf(line, "%d", &most) != 1 || most != 255)
        return broken;
    image->pixels = h.at;
    if (image->width < 1 || image->width > FROB_IMAGE_SIDE || image->height < 1)
        return broken;
    image->stride = image->width * frob_image_pixel_size(image->format);
    if (!frob_image_is_sound(image))
        return broken;
    if ((size_t)(h.end - h.at) != row_size(image) * (size_t)image->height)
        return "its size does not match its header";
    return NULL;
}
