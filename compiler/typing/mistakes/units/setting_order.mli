(** The order of arguments if a number without a unit comes after the signal, but the function takes
    its settings first: [lowPass x 0.5], [clamp x 0 0.4]. *)

val wrong : Show.words -> expected:Expected.t -> found:Type.t -> Basis.Diagnostic.t option
(** The message, if the mismatch is in an argument of such a function. *)
