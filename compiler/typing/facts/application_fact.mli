(** The facts that inference collects about an application in which one argument has the wrong type.
*)

open Basis

type call = {
  at : Span.t;  (** the whole application *)
  head : Resolve.Ir.expr;
  arguments : (Resolve.Ir.expr * Type.t) list;
      (** the arguments, with their types; [Erroneous] for the failing argument if it is wrong in
          itself *)
  failed : int;  (** the position of the failing argument, counted from 1 *)
  is_right_alone : bool;  (** whether the failing argument is correct in itself *)
  takes : int;  (** number of parameters of the head *)
  result : Type.t;  (** the type of the head applied to one argument *)
  exchanged : int option;
      (** the position of another argument; the types fit if it is swapped with the failing one *)
  rotated : int list option;  (** another order in which the types fit *)
  lacking : int option;
      (** the number of arguments that are missing before the failing one, if the arguments from
          there on fit the last parameters *)
}

type method_call = {
  at : Span.t;  (** the whole application *)
  record : Resolve.Ir.expr;
  field : Syntax.Ir.name;
  arguments : Resolve.Ir.expr list;
}
(** [xs.map f], an array function that is called like a method. *)
