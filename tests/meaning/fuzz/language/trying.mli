(** Random tests and trials of a program: what [frobc test] runs, and what is nothing to anyone
    else. They need the imports of {!imports}. *)

type program = {
  name : string;  (** of its signal function, of the input that all programs have *)
  signals : Type.t list;  (** its output, a tuple of these *)
}

val imports : string

type observer = {
  label : string;
  seconds : float;
  judge : string;  (** an expression *)
  claims : (string * string * string) list;  (** [assert] or [assume], a label, an expression *)
  equations : string list;  (** of what these mention *)
}
(** What is said of a program for a time, on an input that is made up. *)

val observer : Scope.t -> program -> string -> observer
(** Of that label. *)

val test : observer -> string
(** It as a test. *)

val reference : string -> observer -> string
(** A signal function of that name, without input, that gives the verdicts: a pair of the judge's,
    and a tuple of () and those on the claims. *)

val some : Scope.t -> program -> string
(** A test, a golden trace or a trial, with files that are not there. *)
