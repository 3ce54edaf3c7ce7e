(** Where C pads least: the small fields of machines are kept apart from the large ones.

    A struct is padded to a multiple of its largest member, so of machines within
    machines each would pad the number of its mode to eight bytes, and each mode what it
    keeps beside numbers. Such a node, and what it holds, has two structs instead: one of
    what is aligned to 8, one of the rest. Its functions are given both; the root's one
    struct has all large parts first. Other nodes have one struct.

    Modes share memory, and do so apart as well: what is aligned to 8 with what is
    aligned to 8, the rest with the rest. So truth values lie upon truth values and not
    within a number, as C compilers want it that keep a state in registers.

    That can take more room, where one mode keeps many truth values and another many
    numbers. Then it is left alone: a state is never larger than with one union. *)

type t

val of_program : Ir.program -> t

val is_split : t -> int -> bool
(** Has that node two structs? *)

(** Part of a field. *)
type part =
  | Large  (** aligned to 8, or the whole field of a node with one struct *)
  | Small

val parts : t -> int -> Ir.field -> part list
(** Of a field of that node's state, or of one of its modes: a field with both has
    a member for each. *)

val in_order : t -> int -> Ir.field list -> (Ir.field * part) list
(** The members that fields make: large parts first, then small ones by alignment. *)

val block : t -> int -> Ir.field * part -> Block.t
(** The room of such a member of that node. *)
