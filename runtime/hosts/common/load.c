#include "load.h"

#include <dlfcn.h>
#include <stdio.h>

const struct frob_program *frob_load(const char *path)
{
    const struct frob_program *program;
    void *object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (object == NULL) {
        fprintf(stderr, "error: %s is not a compiled program: %s\n", path, dlerror());
        return NULL;
    }
    program = (const struct frob_program *)dlsym(object, FROB_PROGRAM_SYMBOL);
    if (program == NULL) {
        fprintf(stderr, "error: %s has no symbol `%s`: it was not made by frobc\n", path,
                FROB_PROGRAM_SYMBOL);
        return NULL;
    }
    if (program->abi != FROB_PROGRAM_ABI) {
        fprintf(stderr, "error: %s was compiled for another version of the runtime\n", path);
        return NULL;
    }
    return program;
}
