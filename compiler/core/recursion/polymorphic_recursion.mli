(** Reports definitions that restart themselves at ever larger types.

    A definition with a signature may use itself at types other than its own. Through the
    continuations of switches, that would create a mode for each of infinitely many types. *)

open Basis

val check : Diagnostic.sink -> Uses.t -> unit
(** Emits E0417 for each such use. Linear time. *)
