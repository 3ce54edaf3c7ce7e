(** The module-level names that are visible in a module, without the resolver's state. *)

open Basis

type import = {
  module_ : string;
  qualifiers : string list;  (** for example [M] and [N] for [import M as N] *)
  unqualified : bool;  (** whether the names may be used without a qualifier *)
  names : Interface.names;
}

type of_library = {
  module_ : string;
  names : Interface.names;  (** the names that it declares, or those listed in its header *)
  gathers : bool;
      (** whether its header lists its exports, which may come from other modules; if so, hints
          suggest this module rather than the others *)
}
(** A library module, for use in hints. *)

type t = {
  text : string;  (** the source text of the module *)
  syntax : Syntax.Ir.program;
  module_ : string;
  own : Interface.names;
  imports : import list;  (** including the prelude *)
  elsewhere : of_library list Lazy.t;  (** the modules of the library *)
  records : Interface.tycon list Interface.String_map.t Lazy.t;
      (** the record types in scope, by field name *)
}

val create :
  text:string ->
  module_:string ->
  own:Interface.names ->
  imports:import list ->
  elsewhere:of_library list Lazy.t ->
  syntax:Syntax.Ir.program ->
  t

val imported : t -> 'a Interface.space -> (import -> bool) -> string -> (import * 'a) list
(** The distinct meanings that a name gets from the imports that satisfy the predicate. *)

val is_known : t -> 'a Interface.space -> string -> bool
(** Does the name have a meaning without a qualifier? *)

val size_named : t -> string -> int option
(** The number that a name such as [N] represents after [type N = 25], unless there is a constructor
    of that name. *)

val names_of : 'a String_table.t -> string list -> string list
(** Adds the names in a table to a list. *)

val names : t -> 'a Interface.space -> string list Lazy.t -> string list
(** The names that have a meaning without a qualifier, and the given local names. *)

val is_implied : import -> bool
(** Is this the implicit import {!Labels.import}? *)
