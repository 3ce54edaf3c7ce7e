(** What the syntax tree of a module says about unknown names in it. Computed on demand, once for
    all its unknown names. *)

type t = {
  visible : Resolve.Visible.t;
  signals : Proc_signals.t list Lazy.t;  (** the signals of all its procs *)
  c_declarations : Proc_signals.c_declaration list Lazy.t;
      (** see {!Proc_signals.c_declarations} *)
  in_capitals : string list Lazy.t;  (** see {!Proc_signals.in_capitals} *)
  without_definition : string list Lazy.t;  (** see {!Proc_signals.without_definition} *)
}

val create : Resolve.Visible.t -> t
