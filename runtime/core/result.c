#include <frob/cell.h>
#include <frob/result.h>

bool frob_has_ended(const struct frob_program *program, const void *output)
{
    /* The event's tag: 0 is NoEvent. */
    return program->result != NULL && ((const uint8_t *)output)[program->result->offset] != 0;
}

void frob_result_write(struct frob_text *text, const struct frob_program *program,
                       const void *output)
{
    if (frob_has_ended(program, output))
        frob_cell_write(text, program->result, output);
}

size_t frob_result_room(const struct frob_program *program)
{
    return program->result == NULL ? 1 : frob_cell_room(program->result) + 1;
}
