(** The facts that inference collects about an application in which one argument has the wrong type.
*)

open Basis

type call = {
  at : Span.t;  (** the whole application *)
  head : Resolve.Ir.expr;
  arguments : (Resolve.Ir.expr * Type.t) list;
      (** the arguments with their types; the type of the failing argument is [Erroneous] if it
          contains an error of its own *)
  failed : int;  (** the position of the failing argument, counted from 1 *)
  is_right_alone : bool;  (** whether the failing argument is correct when checked on its own *)
  takes : int;  (** number of parameters of the head *)
  result : Type.t;  (** the type of the head applied to one argument *)
  exchanged : int option;
      (** the position of the argument that must be swapped with the failing one to make the types
          fit *)
  rotated : int list option;  (** another order in which the types fit *)
  lacking : int option;
      (** the number of arguments missing before the failing one, if the failing argument and those
          after it fit the last parameters *)
}

type method_call = {
  at : Span.t;  (** the whole application *)
  record : Resolve.Ir.expr;
  field : Syntax.Ir.name;
  arguments : Resolve.Ir.expr list;
}
(** [xs.map f], an array function that is called like a method. *)
