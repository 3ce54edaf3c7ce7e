(** Where C pads least: of a machine within a machine the small fields are kept apart
    from the large ones.

    A struct is padded to a multiple of its largest member, so of machines within
    machines each would pad the number of its mode to eight bytes. Such a node, and
    what it holds, has two structs instead: one of what is aligned to 8, one of the
    rest. Its functions are given both; the root's one struct has all large parts
    first. Other nodes have one struct. *)

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
