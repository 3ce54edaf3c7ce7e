(** Finds the sources of a column's value: one step back along the equations.

    From the equation of a signal, the search goes back through everything that does not have its
    own column (such as the results of functions, and signals without a name) to the nearest
    columns. These can be parameters, signals of other equations, inner signals of instances, or the
    program's input. *)

open Basis

type back =
  | Instants of int
      (** the number of instants ago, counted in instants of the enclosing signal function; 0 is the
          current instant *)
  | First
      (** the source matters only in the first instant of the signal function that contains the
          signal *)
  | Entry
      (** the signal is a parameter of a mode, and the source matters only when that mode is entered
      *)

type source = {
  column : string;
  back : back;
  where_ : (string * int) option;
      (** the innermost mode in which the source matters: the column of its machine, and the mode's
          number. For [Entry], this is the mode that was left: {!any} if the machine's input caused
          the transition, or {!before} if the machine was starting *)
}

val any : int
val before : int

type transition = {
  from : int;
      (** number of a mode; {!any} if the machine's input causes the transition; {!before} for the
          start of the machine *)
  target : int;
  label : string;  (** the name of the event that causes the transition; empty if unknown *)
  delayed : bool;  (** whether the previous mode still runs in the instant of the transition *)
  at_once : bool;  (** whether the transition may occur in the first instant of the previous mode *)
  sources : source list;  (** sources of the event *)
  place : Span.t;
}
(** A transition between the modes of a machine. *)

type t = {
  column : string;  (** for example [probe.follow.v] or [out.turn] *)
  place : Span.t;  (** the whole equation; for a parameter or input, the place of the argument *)
  sources : source list;
  transitions : transition list;
      (** the transitions of the machine, if the column is its running mode *)
}

val of_program : Equations.t -> Flow.Ir.program -> Catalogue.probe list -> t list
(** The sources of the output's leaves and of these probes. Columns are named as in a trace. If the
    index of an array element is not known, the source is the column of the whole array. *)
