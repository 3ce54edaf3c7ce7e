(** Labels that show why an expression must have a particular type. *)

open Basis
open Typing

val defines : at:Span.t -> string -> Diagnostic.t -> Diagnostic.t
(** Labels the definition of this name. *)

val add : Wording.t -> Expected.t -> Diagnostic.t -> Diagnostic.t
(** Labels the place that determines the expected type. *)

val hides :
  Wording.t ->
  Resolve.Ir.Local.t ->
  Resolve.Ir.Global.t * Type.t ->
  Basis.Diagnostic.t ->
  Basis.Diagnostic.t
(** Says that the local variable hides this function. *)

val add_all :
  Wording.t -> subject:Resolve.Ir.expr option -> Expected.t -> Diagnostic.t -> Diagnostic.t
(** Like {!add}. If no place determines the type, labels the place where the offending variable is
    bound. *)
