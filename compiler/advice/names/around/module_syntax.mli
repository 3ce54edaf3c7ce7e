(** Facts about a module that are read from its syntax tree, for messages about unknown names. Each
    one is computed when it is first needed, and then reused for all unknown names of the module. *)

type t = {
  visible : Resolve.Visible.t;
  signals : Proc_signals.t list Lazy.t;  (** the signals of all its procs *)
  c_declarations : Proc_signals.c_declaration list Lazy.t;
      (** see {!Proc_signals.c_declarations} *)
  in_capitals : string list Lazy.t;  (** see {!Proc_signals.in_capitals} *)
  without_definition : string list Lazy.t;  (** see {!Proc_signals.without_definition} *)
}

val create : Resolve.Visible.t -> t
