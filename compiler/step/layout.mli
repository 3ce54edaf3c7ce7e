(** How values lie in memory, as far as the language fixes it.

    A sum is a struct of a tag and slots that all its constructors share: as many Floats, 32-bit
    integers, bools and inner tags as the constructor that needs most of each. A payload that is
    itself a sum is laid flat into the slots: its tag takes an inner-tag slot, its slots follow. An
    array is a slot of its own, shared with arrays of the same type; so is a value of a foreign
    type. *)

type slots = {
  floats : int;
  ints : int;
  bools : int;
  tags : int;
  arrays : (Flow.Ir.ty * int) list;
      (** how many of each type of array, and each foreign type; sorted *)
}

val none : slots
val add : slots -> slots -> slots

val arrays_before : slots -> Flow.Ir.ty -> int
(** How many of this type. *)

val ty : Flow.Ir.ty -> Ir.ty

val leaf : Flow.Ir.sum array -> Flow.Ir.ty -> slots
(** What one leaf takes inside a payload. *)

val sum : Flow.Ir.sum array -> int -> slots
(** Without the sum's own tag. *)
