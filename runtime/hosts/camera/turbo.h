/* turbo.h -- libjpeg-turbo, loaded when the first JPEG is read or written. Hosts are not linked
 * with the library, so only users of cameras that send JPEG need it. */
#ifndef FROB_HOST_CAMERA_TURBO_H
#define FROB_HOST_CAMERA_TURBO_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
    TURBO_RGB = 0,  /* TJPF_RGB */
    TURBO_GREY = 6, /* TJPF_GRAY */
    TURBO_SAMPLES_422 = 1,
    TURBO_SAMPLES_GREY = 3,
    TURBO_ACCURATE = 4096 /* TJFLAG_ACCURATEDCT: the same pixels on every machine */
};

/* The library functions that hosts use, as declared in <turbojpeg.h>. */
struct turbo {
    void *(*init_decompress)(void);
    void *(*init_compress)(void);
    int (*header)(void *handle, const unsigned char *jpeg, unsigned long size, int *width,
                  int *height, int *samples, int *space);
    int (*decompress)(void *handle, const unsigned char *jpeg, unsigned long size,
                      unsigned char *pixels, int width, int pitch, int height, int format,
                      int flags);
    int (*compress)(void *handle, const unsigned char *pixels, int width, int pitch, int height,
                    int format, unsigned char **jpeg, unsigned long *size, int samples, int quality,
                    int flags);
    void (*release)(unsigned char *jpeg);
    char *(*error)(void *handle);
    int (*destroy)(void *handle);
};

/* Loads the library once. On failure, returns NULL and stores the name of the missing part in
   `fault`. */
const struct turbo *turbo_find(const char **fault);

#ifdef __cplusplus
}
#endif
#endif
