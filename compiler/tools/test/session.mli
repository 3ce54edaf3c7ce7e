(** The state that all tests of a command share. *)

type options = {
  pattern : string option;  (** run only the tests whose labels contain this text *)
  seeds : int option;  (** number of seeds for each trial, starting with the trial's first seed *)
  jobs : int option;
      (** maximum number of concurrent processes; by default the number of processors *)
  rate : float;  (** Hz *)
  json : bool;  (** whether to print one JSON object per line instead of text *)
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
      (** files and entries that {!Checking.compiled} could not compile, each with a short reason *)
  names : (string, string * string) Hashtbl.t;
      (** for each name that {!Checking.kept} has assigned: the file and the label of its test *)
}
