(** Random tests and trials of a program, which only [frobc test] runs. They need {!imports}. *)

type program = {
  name : string;  (** name of its signal function, which takes the common input type *)
  signals : Type.t list;  (** types of the components of its output tuple *)
}

val imports : string

type observer = {
  label : string;
  seconds : float;
  judge : string;  (** an expression *)
  claims : (string * string * string) list;  (** [assert] or [assume], a label, an expression *)
  equations : string list;  (** equations that define the names in these expressions *)
}
(** An observer of a program: it runs the program for some time on a generated input and judges it.
*)

val observer : Scope.t -> program -> string -> observer
(** An observer with this label. *)

val test : observer -> string
(** The observer as a test. *)

val reference : string -> observer -> string
(** A signal function of this name, without input, that outputs the verdicts: a pair of the judge's
    verdict, and a tuple of () and the claims' verdicts. *)

val some : Scope.t -> program -> string
(** A test, or a golden trace or trial whose files do not exist. *)
