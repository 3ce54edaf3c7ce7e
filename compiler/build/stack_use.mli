(** Reports programs that need more stack than is available. *)

open Basis

val guarded : Diagnostic.sink -> Source.t -> Request.t -> otherwise:'a -> (unit -> 'a) -> 'a
(** Calls the function and returns its result. If the stack overflows, reports E0106 at the largest
    definition of the request's file, and returns [otherwise]. *)
