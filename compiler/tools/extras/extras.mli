(** Python packages of others, in an environment that belongs to frobc.

    The environment is in [XDG_DATA_HOME/frobc] or [~/.local/share/frobc], and is not used if the
    user has activated a virtual environment. It uses the Python package frob of this frobc. *)

type group = {
  name : string;
  packages : (string * string) list;  (** names in the package index, and of the modules *)
  purpose : string;
}

val groups : group list

val install : string list -> int
(** [frobc extras install GROUP…]. Without a group, installs those that are installed again. The new
    environment, with the groups of the old one, replaces it only when it is complete. *)

val list : unit -> int
(** [frobc extras list]. *)

val python : modules:string list -> string option
(** The Python to use for a command that needs these modules: the one of an active virtual
    environment; otherwise the first that has the modules, of the environment, the Python that frobc
    was installed for, and [python3]; or the first that exists, if none has them. Sets [PYTHONPATH]
    so that it finds the package frob of this frobc, if it does not have its own. *)

val command : string -> string
(** The command that installs a group, for messages. *)

val state : group -> (string list, string) result
(** The installed packages of a group, with their versions; or the reason why it is not usable. *)
