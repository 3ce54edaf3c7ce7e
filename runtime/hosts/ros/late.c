#include "late.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Maximum length of the names of libraries and functions. */
enum { NAME = 400 };

void *late_library(const char *name)
{
    const char *prefix = getenv("AMENT_PREFIX_PATH");
    char path[1024];
    void *library;
    while (prefix != NULL && *prefix != '\0') {
        const size_t length = strcspn(prefix, ":");
        snprintf(path, sizeof path, "%.*s/lib/lib%s.so", (int)length, prefix, name);
        library = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
        if (library != NULL)
            return library;
        prefix += length + (prefix[length] == ':' ? 1 : 0);
    }
    snprintf(path, sizeof path, "lib%s.so", name);
    return dlopen(path, RTLD_NOW | RTLD_GLOBAL);
}

bool late_messages(const char *package, char *why, size_t room)
{
    static const char *const endings[] = { "generator_c", "typesupport_c" };
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        char library[NAME];
        snprintf(library, sizeof library, "%s__rosidl_%s", package, endings[i]);
        if (late_library(library) == NULL) {
            snprintf(why, room, "the ROS 2 message package %s is not installed: install it",
                     package);
            return false;
        }
    }
    return true;
}

late_function *late_find(const char *library, const char *name)
{
    void *loaded = late_library(library);
    void *symbol = loaded != NULL ? dlsym(loaded, name) : NULL;
    late_function *function = NULL;
    if (symbol != NULL)
        memcpy(&function, &symbol, sizeof function);
    return function;
}

/* Calls the library function that returns a type support. `kind` and `folder` are "message" and
 * "msg", or "service" and "srv". */
static const void *type_support(const char *package, const char *kind, const char *folder,
                                const char *name)
{
    char library[NAME], symbol[NAME];
    const void *(*function)(void);
    snprintf(library, sizeof library, "%s__rosidl_typesupport_c", package);
    snprintf(symbol, sizeof symbol, "rosidl_typesupport_c__get_%s_type_support_handle__%s__%s__%s",
             kind, package, folder, name);
    function = (const void *(*)(void))late_find(library, symbol);
    return function != NULL ? function() : NULL;
}

const rosidl_message_type_support_t *late_message_type(const char *package, const char *name)
{
    return (const rosidl_message_type_support_t *)type_support(package, "message", "msg", name);
}

const rosidl_service_type_support_t *late_service_type(const char *package, const char *name)
{
    return (const rosidl_service_type_support_t *)type_support(package, "service", "srv", name);
}
