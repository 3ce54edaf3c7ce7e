(** Lays out the state in C structs: decides which struct contains the fields of each node, and in
    which order.

    Most nodes have no struct of their own: their fields are members of the struct of the node that
    contains them, so that small fields of many nodes share the padding. A node has its own struct
    if its state occurs more than once: in several instances, in an array, or in a copy for a trial
    step. The root and the components in the user's C code have their own structs, too, and so do
    nodes in deeply nested modes.

    Members with the largest alignment come first, so that no padding is needed between them. Among
    members with the same alignment, times come last: compilers copy two adjacent floats with one
    instruction if no time is between them.

    The modes of a machine share memory in unions. The first union contains the members with the
    largest alignment. A mode that needs less of this union than others also stores smaller members
    there. The remaining, smaller members are in further unions, among the small members of the
    struct. *)

type member = {
  path : string list;
      (** names of the field and of the fields that contain it in the struct, outermost first *)
  node : int;  (** the node to which the field belongs *)
  field : Ir.field;
  block : Block.t;
  modes : (int * member list) list;
      (** for a field of [Modes]: the modes that have members in this union, each with its number;
          empty for other fields *)
}

type t

val of_program : Ir.program -> t

val home : t -> int -> int
(** The node whose struct contains the fields of this node. Often it is the node itself. *)

val members : t -> int -> member list
(** The members of the struct of a node, in order; empty for a node without a struct of its own. *)
