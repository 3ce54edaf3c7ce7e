#include <frob/lens.h>

#include <string.h>

void frob_image_lens(const struct frob_image *image, struct frob_lens *result)
{
    const struct frob_camera *c = &image->camera;
    result->width = image->width;
    result->height = image->height;
    result->focalX = c->focal_x;
    result->focalY = c->focal_y;
    result->centreX = c->centre_x;
    result->centreY = c->centre_y;
    result->k1 = c->k1;
    result->k2 = c->k2;
    result->k3 = c->k3;
    result->p1 = c->p1;
    result->p2 = c->p2;
    result->ahead = c->x_m;
    result->left = c->y_m;
    result->up = c->z_m;
    result->yaw = c->yaw_rad;
    result->pitch = c->pitch_rad;
    result->roll = c->roll_rad;
}

/* A step of FNV-1a on 64-bit words, followed by folding the high bits into the low ones. */
static uint64_t stirred(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * UINT64_C(0x100000001b3);
    return hash ^ hash >> 29;
}

int32_t frob_image_key(const struct frob_image *image)
{
    const struct frob_camera *c = &image->camera;
    const double seat[] = { c->focal_x, c->focal_y, c->centre_x, c->centre_y,  c->k1,
                            c->k2,      c->k3,      c->p1,       c->p2,        c->x_m,
                            c->y_m,     c->z_m,     c->yaw_rad,  c->pitch_rad, c->roll_rad };
    uint64_t hash = stirred(UINT64_C(0xcbf29ce484222325), (uint64_t)image->captured_ns);
    uint32_t low;
    int32_t key;
    hash = stirred(hash, image->number);
    hash = stirred(hash, (uint64_t)(uint32_t)image->width << 32 | (uint32_t)image->height);
    for (size_t i = 0; i < sizeof seat / sizeof seat[0]; i++) {
        uint64_t bits;
        memcpy(&bits, &seat[i], sizeof bits);
        hash = stirred(hash, bits);
    }
    low = (uint32_t)hash;
    memcpy(&key, &low, sizeof key);
    return key;
}
