(** What each name in a text means: where that is declared, in whatever module. *)

open Basis

type what =
  | Local
  | Value of Resolve.Ir.Global.t  (** a definition, a primitive, a method or a parameter *)
  | Constructor of Resolve.Ir.Global.t
  | Type of Resolve.Ir.Global.t
  | Class of Resolve.Ir.Global.t
  | Unit of Resolve.Ir.Global.t
  | Field of { record : string  (** its constructor *) }
  | Module

type symbol = {
  name : string;
  what : what;
  at : Span.t;  (** of the name where it is declared: tells symbols apart *)
}

type occurrence = { place : Span.t; symbol : symbol; declares : bool }
type t

val of_analysis : Analysis.t -> typed:Typing.Ir.program option -> Syntax.Ir.program -> t
(** Of the text that the analysis and the tree are of; [typed], of the same text, knows of which
    record a field is. *)

val all : t -> occurrence list
(** In order of their places. *)

val at : t -> Span.position -> occurrence option
(** That a cursor there is in, or behind. *)

val same : symbol -> symbol -> bool
