(** Tables by the names of declarations. *)

include Hashtbl.S with type key = Ir.Global.t
