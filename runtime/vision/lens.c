#include <frob/lens.h>

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
