(** The machines of a program as states and arrows, for drawings. *)

type source =
  | Start  (** the start of the machine *)
  | Any  (** an event from outside, in any state *)
  | State of int  (** the number of a state *)

type arrow = {
  source : source;
  target : int;  (** the number of a state *)
  label : string;  (** the signal function that causes the transition; [""] if it is not known *)
  may_be_immediate : bool;
      (** whether the transition may occur in the first instant of the state that it leaves *)
  delayed : bool;  (** whether the output in this instant still comes from the old state *)
}

type state = {
  name : string;  (** its name in the program *)
  place : string;  (** [line 5], or [Robot.frob:5] for another file *)
  inside : int list;  (** the numbers of the machines that run inside this state *)
}

type t = { title : string; states : state list; arrows : arrow list }

val of_program : Flow.Ir.program -> t list
(** The machines of a program. The number of a machine is its index in this list, and the number of
    a state is its index in [states]. *)
