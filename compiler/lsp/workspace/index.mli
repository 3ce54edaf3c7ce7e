(** Maps each name in a text to its declaration, which may be in another module. *)

open Basis

type what =
  | Local
  | Value of Resolve.Ir.Global.t  (** a definition, a primitive, a method or a parameter *)
  | Constructor of Resolve.Ir.Global.t
  | Type of Resolve.Ir.Global.t
  | Class of Resolve.Ir.Global.t
  | Unit of Resolve.Ir.Global.t
  | Field of { record : string  (** constructor of the record *) }
  | Module

type symbol = {
  name : string;
  what : what;
  at : Span.t;  (** the place of the name in its declaration, which identifies the symbol *)
}

type occurrence = { place : Span.t; symbol : symbol; declares : bool }
type t

val of_analysis :
  Mentions.declared Text_cache.t ->
  Analysis.t ->
  typed:Typing.Ir.program option ->
  Syntax.Ir.program ->
  t
(** Builds the index from the analysis and tree of a text. [typed], the typed program of the same
    text, determines which record each field belongs to. The cache contains the declarations of
    other modules. *)

val all : t -> occurrence list
(** In source order. *)

val at : t -> Span.position -> occurrence option
(** The occurrence that contains this position or ends at it. *)

val same : symbol -> symbol -> bool
