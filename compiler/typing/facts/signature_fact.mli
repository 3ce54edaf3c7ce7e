(** A definition that fits its signature only if two types of the signature are exchanged. *)

open Basis

type kind =
  | Input_and_output  (** the two types of a signal function, a task or a program *)
  | Elements
  | Parameters of int * int  (** their indices *)
  | Parameter_and_result

type t = {
  name : string;  (** the definition's name *)
  binding : Resolve.Ir.binding;
  written : Resolve.Ir.scheme;  (** the signature *)
  kind : kind;
  first : Resolve.Ir.ty;
  second : Resolve.Ir.ty;
  edits : (Span.t * string) list;  (** exchange the two types *)
  text : string;  (** the signature after the exchange *)
}
