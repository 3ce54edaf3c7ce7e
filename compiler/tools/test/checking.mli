(** State shared by all tests of a command, and functions for running a test. *)

type options = {
  pattern : string option;  (** runs only tests whose labels contain this text *)
  seeds : int option;  (** number of seeds for each trial, starting with its first *)
  jobs : int option;
      (** maximum number of concurrent processes; by default the number of processors *)
  rate : float;  (** Hz *)
  json : bool;  (** print one JSON object per line instead of text *)
  junit : string option;  (** file with results for a CI server *)
  update : bool;  (** rewrite golden traces *)
  keep : string;  (** folder for recordings and pictures of failed runs *)
}

type t = {
  general : Common_options.t;
  sources : string list;  (** the user's C files *)
  options : options;
  resources : Resources.t;
  jobs : int;
  rejected : (string * string, string) Hashtbl.t;
      (** files and entries that {!compiled} could not compile, each with a short reason *)
  names : (string, string * string) Hashtbl.t;
      (** for each name that {!kept} has assigned: the file and the label of its test *)
}

val alone : Common_options.t -> sources:string list -> Resources.t -> t
(** The state for commands that run no tests. *)

val read : string -> string
(** The text of an existing file. *)

val beside : string -> string -> string
(** [beside file name] resolves the path [name] relative to the folder of [file]. *)

val compiled : t -> Common_options.t -> entry:string -> string -> (string, string) result
(** The path of a program compiled for hosts. Compilation errors are reported before it returns. *)

val measures : t -> entry:string -> string -> (Measures.t list, string) result
(** [measures context ~entry file] are the measures of the judge [entry] in the file. *)

val complaint : Workers.result -> string
(** The first line of a host's error message. *)

val quoted : string -> string
(** Quotes a word for a shell. *)

val program_words : t -> string
(** The options that a printed command needs to compile the same program, each quoted and preceded
    by a space. *)

val test_again : t -> string -> Checks.t -> string
(** [test_again context file check] is the command that repeats a test. *)

val kept : t -> string -> Checks.t -> string -> string
(** [kept context file check ending] is the path, without its extension, of files about a failed run
    of a test: [keep], the slug of the label, and [ending]. If {!kept} has assigned that name to
    another test, the program's name is added after the slug, and then a number if necessary. *)
