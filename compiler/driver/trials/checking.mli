(** What all tests of a command have in common, and what running one needs. *)

type options = {
  pattern : string option;  (** only tests with this in their label *)
  seeds : int option;  (** so many for each trial, from its first on *)
  jobs : int option;  (** so many processes at a time; as many as there are processors *)
  rate : float;  (** Hz *)
  json : bool;  (** an object a line instead of text *)
  junit : string option;  (** a file for a CI server *)
  update : bool;  (** write golden traces anew *)
  keep : string;  (** the folder for what can be looked at of runs that failed *)
}

type t = {
  general : General.t;
  sources : string list;  (** of the user's in C *)
  options : options;
  resources : Resources.t;
  jobs : int;
  rejected : (string * string, string) Hashtbl.t;
      (** of files and entries that {!compiled} could not compile: why, in a few words *)
}

val alone : General.t -> sources:string list -> Resources.t -> t
(** For what runs no tests, and needs what they have in common. *)

val read : string -> string
(** The text of a file that is there. *)

val compiled : t -> General.t -> entry:string -> string -> (string, string) result
(** The path of a program for hosts. What is wrong with it has been told. *)

val measures : t -> entry:string -> string -> (Measures.t list, string) result
(** What the judge of that name measures. *)

val complaint : Workers.result -> string
(** The first line of what a host complains of. *)

val quoted : string -> string
(** A word of a command, for a shell. *)

val robot_option : General.t -> string
(** With a blank before it, for a command that is told; empty without one. *)

val kept : t -> Checks.t -> string -> string
(** Where what can be looked at of a failed run is put: a file in [keep] with this ending. *)
