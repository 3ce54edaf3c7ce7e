(** Calls the kernels of the runtime ({!Kernels}): converts the arguments from Core values to their
    layout in C, and the results back.

    Generated C uses the same structs ([docs/foreign.md]). This module derives their layout
    separately, from the rules of C. Kernels take and return numbers, Bools, and records, tuples and
    arrays of these, but not values of sum types. They also take images, but do not return them. *)

val apply : Core.Ir.program -> Core.Primitive.foreign -> Value.thunk list -> Value.t
(** Calls a known kernel with all its arguments. The argument types are in the program's list of
    imports. *)
