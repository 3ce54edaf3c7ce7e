(** The memory layout of values, as far as the language determines it.

    A sum is a struct with a tag and slots that its constructors share. For each kind of slot
    (Floats, 32-bit integers, Bools and inner tags), the number of slots is the largest number that
    any constructor needs. A sum inside a payload is flattened into the slots: its tag takes the
    slot of an inner tag, and its own slots follow. An array has a separate slot, shared with arrays
    of the same type in other constructors. The same is true of a value of a foreign type. *)

type slots = {
  floats : int;
  ints : int;
  bools : int;
  tags : int;
  arrays : (Flow.Ir.ty * int) list;
      (** number of slots for each array type and each foreign type; sorted *)
}

val none : slots
val add : slots -> slots -> slots

val arrays_before : slots -> Flow.Ir.ty -> int
(** The number of slots of this type. *)

val ty : Flow.Ir.ty -> Ir.ty

val leaf : Flow.Ir.sum array -> Flow.Ir.ty -> slots
(** The slots that one leaf takes inside a payload. *)

val sum : Flow.Ir.sum array -> int -> slots
(** The slots of a sum, without its own tag. *)
