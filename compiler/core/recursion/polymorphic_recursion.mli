(** No definition may start itself again at ever larger types.

    A definition with a signature may use itself at other types than its own. Through the
    continuations of switches that would be a mode for each of infinitely many types. *)

open Basis

val check : Diagnostic.sink -> Uses.t -> unit
(** Emits E0417 for each such use. Linear. *)
