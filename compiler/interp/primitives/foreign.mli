(** Calls of the runtime's kernels ({!Kernels}): values of Core as C has them, and back.

    Generated C has the same structs ([docs/foreign.md]); what they are is said here once more, from
    the rules of C. Kernels take and give numbers, truths, images, records, tuples and arrays of
    these, but no sums. *)

val apply : Core.Ir.program -> Core.Primitive.foreign -> Value.thunk list -> Value.t
(** Of a known kernel, on all arguments; the program's list of imports has their types. *)
