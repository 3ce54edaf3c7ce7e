(** What a module-level name means at a place in a module: its own declarations hide what it
    imports; two imports of one name clash only where the name is used. *)

open Basis

type import = {
  module_ : string;
  qualifiers : string list;  (** [M] and [N] of [import M as N] *)
  unqualified : bool;  (** may be used without a qualifier *)
  names : Interface.names;
  span : Span.t;
}

type of_library = {
  module_ : string;
  names : Interface.names;  (** what it declares, or what its header lists *)
  gathers : bool;  (** its header lists names of others too: it is what one imports *)
}
(** A module of the library, for hints. *)

type t = {
  context : Context.t;
  syntax : Syntax.Ir.program;
  module_ : string;
  library : bool;
  own : Interface.names;
  imports : import list;  (** with the prelude *)
  complete : bool;
      (** every import was found; otherwise an unknown name is not reported, since it may be the
          missing module's *)
  elsewhere : of_library list Lazy.t;  (** the modules of the library *)
  used : unit Basis.String_table.t;  (** names that the module uses of what it imports *)
  records : Interface.tycon list Interface.String_map.t Lazy.t;
      (** the record types in scope, by the name of a field *)
  records_of : Ir.Global.t list Interface.String_map.t Lazy.t;
      (** their names: one list for all uses of a field, as it may be long *)
  signals : Proc_signals.t list Lazy.t;  (** of all procs of the module, for messages *)
  c_declarations : (Syntax.Ir.name * Syntax.Ir.name) list Lazy.t;
      (** see {!Proc_signals.c_declarations} *)
  in_capitals : string list Lazy.t;  (** see {!Proc_signals.in_capitals} *)
  params : Syntax.Ir.name list Lazy.t;  (** those that the module declares *)
  without_definition : string list Lazy.t;  (** see {!Proc_signals.without_definition} *)
}

val create :
  Context.t ->
  module_:string ->
  library:bool ->
  own:Interface.names ->
  imports:import list ->
  complete:bool ->
  elsewhere:of_library list Lazy.t ->
  syntax:Syntax.Ir.program ->
  t

val find : t -> 'a Interface.space -> Syntax.Ir.qualified -> 'a option
(** Emits a diagnostic if the name is unknown or ambiguous. *)

val find_value :
  t ->
  locals:string list Lazy.t ->
  signals:Proc_signals.t list Lazy.t ->
  Syntax.Ir.qualified ->
  Interface.value option
(** Likewise; the local names may be suggested. The [signals] are those of a [proc]s in the
    definition; those that can be seen from here are among the locals. *)

val look : t -> 'a Interface.space -> Syntax.Ir.name -> 'a option
(** The meaning of an unqualified name that need not have one; silent unless it is ambiguous. *)

val records_with : t -> string list -> Ir.Global.t list
(** The record types in scope that have all these fields, in order of their names. *)
