/* Functions called from OCaml. An image is represented by its address, boxed as a native integer;
 * images stay in memory until the process ends. */
#include "calls.h"
#include "frames.h"

#include <caml/alloc.h>
#include <caml/fail.h>
#include <caml/memory.h>
#include <caml/mlvalues.h>

#include <stdlib.h>
#include <string.h>

enum { MOST_ARGUMENTS = 16 };

/* Returns the index of a kernel, or -1 if there is no kernel with this name. */
value frob_kernel_find(value name)
{
    for (size_t i = 0; i < frob_kernel_count; i++)
        if (strcmp(frob_kernels[i].name, String_val(name)) == 0)
            return Val_long(i);
    return Val_long(-1);
}

/* Takes a list of [Image address | Struct bytes], and bytes for the result. Nothing is allocated in
 * the OCaml heap, so no value moves. */
value frob_kernel_call(value kernel, value arguments, value result)
{
    const void *addresses[MOST_ARGUMENTS];
    size_t count = 0;
    for (; arguments != Val_emptylist && count < MOST_ARGUMENTS; arguments = Field(arguments, 1)) {
        const value argument = Field(arguments, 0);
        addresses[count++] = Tag_val(argument) == 0
                                 ? (const void *)Nativeint_val(Field(argument, 0))
                                 : (const void *)Bytes_val(Field(argument, 0));
    }
    frob_kernels[Long_val(kernel)].call(addresses, Bytes_val(result));
    return Val_unit;
}

value frob_kernel_frames(value record)
{
    struct frame_reader *reader = (struct frame_reader *)malloc(sizeof *reader);
    if (reader == NULL || !frame_reader_open(reader, String_val(record), true))
        caml_raise_out_of_memory();
    return caml_copy_nativeint((intnat)reader);
}

/* Returns (image, ""), or (0, what was expected). */
value frob_kernel_frame(value frames, value number, value size, value hash)
{
    CAMLparam4(frames, number, size, hash);
    CAMLlocal3(result, image, text);
    struct frame_reader *reader = (struct frame_reader *)Nativeint_val(frames);
    const struct frob_frame_name name = { (uint32_t)Long_val(number), (uint64_t)Int64_val(size),
                                          (uint64_t)Int64_val(hash) };
    const char *expected = "";
    const struct frob_image *found = reader->finder.find(reader->finder.context, &name, &expected);
    image = caml_copy_nativeint((intnat)found);
    text = caml_copy_string(found == NULL ? expected : "");
    result = caml_alloc_tuple(2);
    Store_field(result, 0, image);
    Store_field(result, 1, text);
    CAMLreturn(result);
}

/* Returns (number, size, hash). */
value frob_kernel_name(value image)
{
    CAMLparam1(image);
    CAMLlocal3(result, size, hash);
    const struct frob_frame_name name =
        frob_frame_name_of((const struct frob_image *)Nativeint_val(image));
    size = caml_copy_int64((int64_t)name.size);
    hash = caml_copy_int64((int64_t)name.hash);
    result = caml_alloc_tuple(3);
    Store_field(result, 0, Val_long(name.number));
    Store_field(result, 1, size);
    Store_field(result, 2, hash);
    CAMLreturn(result);
}
