(** Hash tables keyed by global names. *)

include Hashtbl.S with type key = Ir.Global.t
