#include "calls.h"

#include <frob/lens.h>

#define IMAGE(k) ((const struct frob_image *)arguments[k])

static void image_lens(const void *const *arguments, void *result)
{
    frob_image_lens(IMAGE(0), (struct frob_lens *)result);
}

const struct kernel frob_kernels[] = {
    { "frob_image_lens", image_lens },
};

const size_t frob_kernel_count = sizeof frob_kernels / sizeof frob_kernels[0];
