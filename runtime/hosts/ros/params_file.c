#include "params_file.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include <rcl_yaml_param_parser/parser.h>
#include <rcutils/allocator.h>
#include <rcutils/error_handling.h>

/* Both pointers point to the start of a part of a name (after a slash), or to the end of the
 * text. */
static bool matches(const char *pattern, const char *node)
{
    const size_t length = strcspn(pattern, "/"), part = strcspn(node, "/");
    const char *rest = pattern + length + (pattern[length] == '/' ? 1 : 0);
    const char *next = node + part + (node[part] == '/' ? 1 : 0);
    if (*pattern == '\0' || *node == '\0')
        return *pattern == *node || strcmp(pattern, "**") == 0;
    if (length == 2 && strncmp(pattern, "**", 2) == 0)
        return matches(rest, node) || matches(pattern, next);
    if (!(length == 1 && *pattern == '*') &&
        (length != part || strncmp(pattern, node, length) != 0))
        return false;
    return matches(rest, next);
}

bool params_file_matches(const char *pattern, const char *node)
{
    return matches(pattern + (*pattern == '/' ? 1 : 0), node + (*node == '/' ? 1 : 0));
}

/* Writes a value as text. A list becomes a string that is not valid for any parameter. */
static void write_value(const rcl_variant_t *value, char *text, size_t room)
{
    if (value->bool_value != NULL)
        snprintf(text, room, "%s", *value->bool_value ? "true" : "false");
    else if (value->integer_value != NULL)
        snprintf(text, room, "%" PRId64, *value->integer_value);
    else if (value->double_value != NULL)
        snprintf(text, room, "%.17g", *value->double_value);
    else
        snprintf(text, room, "%s", value->string_value != NULL ? value->string_value : "a list");
}

bool params_file_read(const char *file, const char *node,
                      void (*set)(void *context, const char *name, const char *value),
                      void *context)
{
    rcl_params_t *params = rcl_yaml_node_struct_init(rcutils_get_default_allocator());
    bool ok = params != NULL && rcl_parse_yaml_file(file, params);
    for (size_t i = 0; ok && i < params->num_nodes; i++) {
        const rcl_node_params_t *of_node = &params->params[i];
        if (!params_file_matches(params->node_names[i], node))
            continue;
        for (size_t k = 0; k < of_node->num_params; k++) {
            char text[400];
            write_value(&of_node->parameter_values[k], text, sizeof text);
            set(context, of_node->parameter_names[k], text);
        }
    }
    if (!ok)
        rcutils_reset_error();
    if (params != NULL)
        rcl_yaml_node_struct_fini(params);
    return ok;
}
