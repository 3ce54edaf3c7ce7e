(** [frobc test]: runs the tests and trials that are written in programs. *)

type options = {
  pattern : string option;  (** only tests with this in their label *)
  seeds : int option;  (** so many for each trial, from its first on *)
  jobs : int option;  (** so many processes at a time; as many as there are processors *)
  rate : float;  (** Hz *)
  json : bool;  (** an object a line instead of text *)
  junit : string option;  (** a file for a CI server *)
  keep : string;  (** the folder for what can be looked at of runs that failed *)
}

val run : General.t -> sources:string list -> options -> string list -> int
(** Of files, and of all files with tests in folders. The outcome does not depend on [jobs]. Exit
    status 1 if one fails. *)
