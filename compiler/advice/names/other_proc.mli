(** Errors about signals of a [proc] that are used outside that [proc]. *)

open Basis

val of_this : Unknown.t -> Diagnostic.t option
(** The error if the [proc] is in the same definition. *)

val of_an_input : Unknown.t -> Diagnostic.t option
(** The error if the name seems to be the input of a [proc] around it or next to it. *)

val of_another : Unknown.t -> Diagnostic.t option
(** The error if the [proc] is in another definition. *)

val of_lambda : Unknown.t -> Diagnostic.t option
(** The error if the name is the parameter of an anonymous function that ends before the [where] in
    which the name is used. *)
