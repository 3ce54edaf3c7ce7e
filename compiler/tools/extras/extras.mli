(** Third-party Python packages, in a virtual environment that only frobc uses.

    The environment is in [XDG_DATA_HOME/frobc] or [~/.local/share/frobc]. If the user has activated
    a virtual environment, frobc uses that environment instead. Python programs in the environment
    can import the package frob that belongs to this frobc. *)

type group = {
  name : string;
  packages : (string * string) list;
      (** for each package, its name in the package index and the name of its module *)
  purpose : string;
}

val groups : group list

val install : string list -> int
(** [frobc extras install GROUP…]. Without a group, reinstalls the groups that are installed. The
    new environment also contains the groups of the old one. It replaces the old one only after a
    complete installation. *)

val list : unit -> int
(** [frobc extras list]. *)

val python : modules:string list -> string option
(** The Python interpreter for a command that needs these modules. If a virtual environment is
    active, returns its interpreter. Otherwise tries three interpreters in this order: the one in
    frobc's environment, the one for which frobc was installed, and [python3]. Returns the first one
    that has the modules, or else the first one that exists. If that interpreter does not have the
    package frob, sets [PYTHONPATH] so that it finds the package of this frobc. *)

val state : group -> (string list, string) result
(** The installed packages of a group, with their versions, or the reason why the group cannot be
    used. *)
