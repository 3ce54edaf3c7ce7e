(** The names that a module declares and exports, before anything in it is resolved: just enough
    that others may refer to them. *)

open Basis
module String_map : Map.S with type key = string
module String_set : Set.S with type elt = string

type value = {
  global : Ir.Global.t;
  signed : bool;
  class_ : Ir.Global.t option;  (** of a method *)
  span : Span.t;
}
(** A definition, a primitive or a method. *)

type constructor = {
  global : Ir.Global.t;
  tycon : Ir.Global.t;
  arity : int;
  fields : string list option;  (** in order, if they have names *)
  span : Span.t;
}

type tycon = {
  global : Ir.Global.t;
  unit_arity : int;
  units_optional : bool;  (** [Float], [Int] and their aliases with a unit alone mean unit 1 *)
  type_arity : int;
  record_fields : string list;
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
(** Tables that nobody changes any more. *)

type 'a space = {
  noun : string;  (** ["type"]; in messages *)
  unknown : string;  (** the code of an unknown name *)
  table : names -> 'a String_table.t;
  global : 'a -> Ir.Global.t;
  place : 'a -> Span.t;
}
(** One of the five name spaces, for what treats them alike. *)

val values : value space
val constructors : constructor space
val tycons : tycon space
val units : unit_name space
val classes : class_ space
val none : unit -> names

val is_operator : string -> bool
(** Is this name a symbol? *)

val builtin_types : file:string -> (string * tycon) list
(** The types without a declaration, owned by the prelude, which is in this file. *)

val is_builtin : tycon -> bool

val is_builtin_class : class_ -> bool
(** [Eq] or [Ord] of the prelude. *)

val declared : Context.t -> module_:string -> Syntax.Ir.program -> names
(** What a module's top level declares; the prelude's has the built-in types and classes. Emits
    E0211 for what is declared twice. *)

val method_names : Syntax.Ir.declaration list -> Syntax.Ir.name list
(** The names that the members of a class declare. *)

val select : names -> String_set.t -> names
(** The part that a list of names in a header or an import speaks of; a type brings its constructors
    and fields, a class its methods. *)

val mem : names -> string -> bool
(** In any of the name spaces. *)

val union : names -> names -> names
(** The first wins. *)

val in_order : 'a String_table.t -> string list
(** The names alone, by the alphabet. *)

val all : names -> string list
(** Of all name spaces. *)
