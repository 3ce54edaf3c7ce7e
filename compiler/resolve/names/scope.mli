(** The meaning of module-level names in a module. Its own declarations hide imported names. Two
    imports of the same name clash only if the name is used. *)

open Basis

type import = {
  module_ : string;
  qualifiers : string list;  (** for example [M] and [N] for [import M as N] *)
  unqualified : bool;  (** may be used without a qualifier *)
  names : Interface.names;
  span : Span.t;
}

type of_library = {
  module_ : string;
  names : Interface.names;  (** the names it declares, or those listed in its header *)
  gathers : bool;  (** its header re-exports names of other modules, so users import this one *)
}
(** A library module, for hints. *)

type t = {
  context : Context.t;
  text : string;  (** the source text of the module, for messages *)
  syntax : Syntax.Ir.program;
  module_ : string;
  library : bool;
  own : Interface.names;
  imports : import list;  (** including the prelude *)
  complete : bool;
      (** every import was found; otherwise unknown names are not reported, because they may belong
          to a missing module *)
  elsewhere : of_library list Lazy.t;  (** the modules of the library *)
  used : unit Basis.String_table.t;  (** imported names that the module uses *)
  records : Interface.tycon list Interface.String_map.t Lazy.t;
      (** the record types in scope, by field name *)
  records_of : Ir.Global.t list Interface.String_map.t Lazy.t;
      (** the names of these types; uses of a field share one list, because it may be long *)
  signals : Proc_signals.t list Lazy.t;  (** signals of all procs in the module, for messages *)
  c_declarations : Proc_signals.c_declaration list Lazy.t;
      (** see {!Proc_signals.c_declarations} *)
  in_capitals : string list Lazy.t;  (** see {!Proc_signals.in_capitals} *)
  params : Syntax.Ir.name list Lazy.t;  (** the parameters that the module declares *)
  without_definition : string list Lazy.t;  (** see {!Proc_signals.without_definition} *)
}

val create :
  Context.t ->
  text:string ->
  module_:string ->
  library:bool ->
  own:Interface.names ->
  imports:import list ->
  complete:bool ->
  elsewhere:of_library list Lazy.t ->
  syntax:Syntax.Ir.program ->
  t

val is_known : t -> 'a Interface.space -> string -> bool
(** Does the name have a meaning without a qualifier? *)

val look : t -> 'a Interface.space -> Syntax.Ir.name -> 'a option
(** Looks up an unqualified name. Reports it only if it is ambiguous, not if it is unknown. *)

val records_with : t -> string list -> Ir.Global.t list
(** The record types in scope that have all these fields, sorted by name. *)

(** {1 For lookups} *)

val imported : t -> 'a Interface.space -> (import -> bool) -> string -> (import * 'a) list
(** The distinct meanings that a name has through the imports that satisfy the predicate. *)

val choose : t -> 'a Interface.space -> Syntax.Ir.name -> (import * 'a) list -> 'a option
(** The only meaning, which then counts as used. Emits a diagnostic if there are several. *)

val size_named : t -> Syntax.Ir.name -> int option
(** The number that a name such as [N] represents after [type N = 25], unless there is a constructor
    of that name. *)

val names_of : 'a Basis.String_table.t -> string list -> string list
(** Adds the names in a table, in order. *)

val visible_names : t -> 'a Interface.space -> string list Lazy.t -> string list
(** The names that have a meaning without a qualifier, and these local ones. *)

val is_implied : import -> bool
(** Is it the import of the prelude, which the program does not write? *)
