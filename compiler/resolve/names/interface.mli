(** The names that a module declares and exports, before anything in it is resolved. Each entry
    contains just enough information for other code to refer to the name. *)

open Basis
module String_map : Map.S with type key = string
module String_set : Set.S with type elt = string

type value = {
  global : Ir.Global.t;
  signed : bool;
  class_ : Ir.Global.t option;  (** the class that a method belongs to *)
  span : Span.t;
}
(** A definition, primitive or method. *)

type constructor = {
  global : Ir.Global.t;
  tycon : Ir.Global.t;
  arity : int;
  fields : string list option;  (** the fields in order, if they are named *)
  span : Span.t;
}

type tycon = {
  global : Ir.Global.t;
  unit_arity : int;
  units_optional : bool;
      (** whether the unit and its brackets may be omitted, which means unit 1, as for [Float],
          [Int] and their aliases with one unit parameter *)
  type_arity : int;
  record_fields : string list;
  size : int option;  (** the number, for an alias such as [type N = 25] *)
  span : Span.t;
}

type unit_name = { global : Ir.Global.t; span : Span.t }
type class_ = { global : Ir.Global.t; methods : string list; span : Span.t }

type names = {
  values : value String_table.t;
  constructors : constructor String_table.t;
  tycons : tycon String_table.t;
  units : unit_name String_table.t;
  classes : class_ String_table.t;
}
(** The tables are not modified after they have been built. *)

type namespace = Values | Constructors | Types | Units | Classes

type 'a space = {
  namespace : namespace;
  table : names -> 'a String_table.t;
  global : 'a -> Ir.Global.t;
  place : 'a -> Span.t;
}
(** One of the five namespaces, for code that handles them uniformly. *)

val values : value space
val constructors : constructor space
val tycons : tycon space
val units : unit_name space
val classes : class_ space

type any_space = Any : 'a space -> any_space

val none : unit -> names

val size_operation : Syntax.Ir.size_operator -> int -> int -> int
(** Arithmetic on sizes, in types. *)

val prelude : string
(** The name of the prelude's module. *)

val is_operator : string -> bool
(** Is the name an operator symbol? *)

val builtin_types : file:string -> (string * tycon) list
(** The built-in types, which have no declaration. They belong to the prelude, whose file is [file].
*)

val builtin_names : file:string -> names
(** The built-in types, their constructors, and the built-in classes. *)

val is_builtin : tycon -> bool

val is_builtin_class : class_ -> bool
(** Is it the prelude's [Eq] or [Ord]? *)

val method_names : Syntax.Ir.declaration list -> Syntax.Ir.name list
(** The method names that a class body declares. *)

val select : names -> String_set.t -> names
(** The entries that the name list of a header or import refers to. A type includes its constructors
    and fields, a class its methods. *)

val mem : names -> string -> bool
(** Is the name in any namespace? *)

val union : names -> names -> names
(** If both define a name, the first argument takes precedence. *)

val in_order : 'a String_table.t -> string list
(** The names, in alphabetical order. *)

val all : names -> string list
(** The names in all namespaces. *)
