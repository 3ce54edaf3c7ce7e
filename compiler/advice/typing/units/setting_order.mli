(** Detects calls that pass the signal first and a number without a unit after it, although the
    function takes its settings first: [lowPass x 0.5], [clamp x 0 0.4]. *)

open Typing

val wrong : Wording.t -> expected:Expected.t -> found:Type.t -> Basis.Diagnostic.t option
(** The message, if the mismatch is in an argument of a function that takes its settings first. *)
