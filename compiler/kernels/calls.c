#include "calls.h"

#include <frob/lens.h>
#include <frob/vision.h>

#define IMAGE(k) ((const struct frob_image *)arguments[k])

static void image_lens(const void *const *arguments, void *result)
{
    frob_image_lens(IMAGE(0), (struct frob_lens *)result);
}

#define REGION(k) ((const struct frob_region *)arguments[k])
#define COLOURS(k) ((const struct frob_colour_range *)arguments[k])

static void find_blob(const void *const *arguments, void *result)
{
    frob_find_blob(IMAGE(0), REGION(1), COLOURS(2), (struct frob_blob *)result);
}

static void find_blobs(const void *const *arguments, void *result)
{
    frob_find_blobs(IMAGE(0), REGION(1), COLOURS(2), (struct frob_blobs *)result);
}

const struct kernel frob_kernels[] = {
    { "frob_find_blob", find_blob },
    { "frob_find_blobs", find_blobs },
    { "frob_image_lens", image_lens },
};

const size_t frob_kernel_count = sizeof frob_kernels / sizeof frob_kernels[0];
