(** What closures are made of. *)

exception Needs_itself of Core.Ir.Local.t

val forced : Value.entry -> Value.t
(** The value of a variable. Raises {!Needs_itself} if its evaluation comes back to it. *)

val code_id : Value.code -> int
(** See {!Free}. *)
