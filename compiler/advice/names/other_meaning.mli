(** Unknown names that have a meaning in another namespace, or in another spelling. *)

open Basis

val diagnostic : Unknown.t -> Diagnostic.t
(** {!Unknown.diagnostic}, with a note about a name that exists in another namespace: [Velocity 3]
    uses a type as a constructor. *)

val spelling : Unknown.t -> string option
(** The name in another spelling that is known. Values and constructors differ only in the case of
    the first letter ([true], [Speed]), and units are written as symbols. *)
