#include "load.h"

#include <dlfcn.h>
#include <stdio.h>

#include <frob/arithmetic.h>

static void *object;

const struct frob_program *frob_load(const char *path)
{
    const struct frob_program *program;
    unsigned faults;
    object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (object == NULL) {
        fprintf(stderr, "error: %s is not a compiled program: %s\n", path, dlerror());
        return NULL;
    }
    program = (const struct frob_program *)dlsym(object, FROB_PROGRAM_SYMBOL);
    if (program == NULL) {
        fprintf(stderr, "error: %s has no symbol `%s`, so it was not compiled by frobc\n", path,
                FROB_PROGRAM_SYMBOL);
        return NULL;
    }
    if (program->abi != FROB_PROGRAM_ABI) {
        fprintf(stderr,
                "error: %s was compiled for another version of the runtime; compile it again\n",
                path);
        return NULL;
    }
    faults = program->arithmetic() | frob_arithmetic_faults();
    if (faults != 0) {
        fprintf(stderr, "error: %s cannot be run: its arithmetic %s\n", path,
                frob_arithmetic_reason(faults));
        return NULL;
    }
    return program;
}

const void *frob_load_part(const char *robot, const char *part)
{
    char name[128];
    int length = snprintf(name, sizeof name, "frob_%s_%s", robot, part);
    if (object == NULL || length < 0 || (size_t)length >= sizeof name)
        return NULL;
    return dlsym(object, name);
}

const struct frob_column *frob_load_columns(void)
{
    return object == NULL ? NULL : (const struct frob_column *)dlsym(object, FROB_COLUMNS_SYMBOL);
}

const struct frob_origin *frob_load_origins(void)
{
    return object == NULL ? NULL : (const struct frob_origin *)dlsym(object, FROB_ORIGINS_SYMBOL);
}
