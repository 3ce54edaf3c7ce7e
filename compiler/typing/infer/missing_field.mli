(** Reports fields that a value does not have, with what the user may have meant. Codes: [E0310] no
    such field · [E0311] several types have it. *)

open Context

val of_record : t -> Syntax.Ir.name -> record:Resolve.Ir.expr -> Type.t -> string list -> unit
(** Reports that the type of [record] does not have the field; the list contains the fields that it
    has. *)

val of_no_type : t -> Syntax.Ir.name -> record:Resolve.Ir.expr -> unit
(** Reports that no type in scope has the field, unless there are other errors, which may be the
    reason. *)

val of_several_types : t -> Syntax.Ir.name -> record:Resolve.Ir.expr -> Ir.Global.t list -> unit
(** Reports that the type of [record] is unknown and these types have such a field. *)

val is_of_arrays : t -> Syntax.Ir.name -> bool
(** Is there a function of that name that takes an array? *)

val path : t -> Type.t -> string -> string option
(** The field of this name in a value of the type, or in a record that is one of its fields. *)
