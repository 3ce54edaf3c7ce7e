#include "turbo.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

static bool find(void *library, const char *name, void *place)
{
    void *symbol = dlsym(library, name);
    memcpy(place, &symbol, sizeof symbol);
    return symbol != NULL;
}

const struct turbo *turbo_find(const char **fault)
{
    static struct turbo turbo;
    static bool found = false;
    void *library;
    if (found)
        return &turbo;
    *fault = "libjpeg-turbo, which reads JPEG, is not installed: on Debian, run `sudo apt-get "
             "install libturbojpeg0`";
    library = dlopen("libturbojpeg.so.0", RTLD_NOW);
    if (library == NULL)
        return NULL;
    found =
        find(library, "tjInitDecompress", &turbo.init_decompress) &&
        find(library, "tjInitCompress", &turbo.init_compress) &&
        find(library, "tjDecompressHeader3", &turbo.header) &&
        find(library, "tjDecompress2", &turbo.decompress) &&
        find(library, "tjCompress2", &turbo.compress) && find(library, "tjFree", &turbo.release) &&
        find(library, "tjGetErrorStr2", &turbo.error) && find(library, "tjDestroy", &turbo.destroy);
    return found ? &turbo : NULL;
}
