(** Unknown names that have a meaning in another namespace, or with a different spelling. *)

open Basis

val diagnostic : Unknown.t -> Diagnostic.t
(** {!Unknown.diagnostic}, with a note if the name exists in another namespace: [Velocity 3] uses a
    type as a constructor. *)

val spelling : Unknown.t -> string option
(** A known name that differs from the unknown one only in spelling. For values and constructors,
    the first letter may differ in case ([true], [Speed]). Units may be spelled out instead of
    written as symbols. *)
