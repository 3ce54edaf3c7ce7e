(** Where the value of a column comes from: one step back along the equations.

    From the signal's equation back through all that has no column of its own (what a function
    computes, what has no name), to the nearest columns: parameters, other equations, signals inside
    of what runs there, the program's input. *)

open Basis

type back =
  | Instants of int  (** so many ago, of the signal function that it is in; 0: the same one *)
  | First  (** only at the first instant of what the signal is in *)
  | Entry  (** when the mode began that the signal is a parameter in *)

type source = {
  column : string;
  back : back;
  where_ : (string * int) option;
      (** only where this machine is in the mode of this number; for [Entry]: where it was before,
          {!any}, or {!before} if the machine itself began. Innermost *)
}

val any : int
val before : int

type transition = {
  from : int;  (** a mode's number, or {!any}, as what is around it says, or {!before} *)
  target : int;
  label : string;  (** what it waits for, as far as that is known; or empty *)
  delayed : bool;  (** the instant at which it happens is still of the mode that is left *)
  at_once : bool;  (** it may happen at the first instant of the mode that it leaves *)
  sources : source list;  (** of the event *)
  place : Span.t;
}
(** Between the modes of a machine. *)

type t = {
  column : string;  (** [probe.follow.v], [out.turn] *)
  place : Span.t;  (** the whole equation; of a parameter or input, where it is given *)
  sources : source list;
  transitions : transition list;  (** if it is the running mode of a machine *)
}

val of_program : Equations.t -> Flow.Ir.program -> Catalogue.probe list -> t list
(** Of the leaves of the output, and of these probes. Columns are called as in a trace; where it is
    not known which element of an array is meant, as the whole array. *)
