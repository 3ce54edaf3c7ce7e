(** Access to the contents of closures. *)

exception Needs_itself of Core.Ir.Local.t

val forced : Value.entry -> Value.t
(** The value of a variable.
    @raise Needs_itself if evaluating the variable requires its own value *)

val code_id : Value.code -> int
(** The id that identifies the code; see {!Free}. *)
