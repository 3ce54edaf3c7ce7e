(** Resolved: a whole program, all of its modules, with names that are declarations instead of text.

    Always true (see {!Lint}): every [Local] is bound exactly once and used within its scope; every
    [Global], type, constructor and unit exists; sections, [if] guards and operators have become
    applications and functions; top-level groups come in dependency order, and within a list of
    local groups too. [proc], do-notation, patterns and fields keep their shape, because later
    messages speak the programmer's syntax. *)

open Basis

(** A variable bound inside a definition; [id] is unique in the program. *)
module Local : sig
  type t = { id : int; name : string; span : Span.t }
end

(** A top-level name. Compared by module and name. *)
module Global : sig
  type t = { module_ : string; name : string }
end

type program = {
  main_module : string;
  modules : module_ list;  (** imports before importers *)
  types : type_declaration list;  (** all modules; used before users *)
  units : unit_declaration list;  (** all modules; used before users *)
  primitives : primitive list;
  classes : class_ list;  (** all modules; superclasses before their subclasses *)
  instances : instance list;
  groups : binding_group list;  (** top level, all modules, dependency order *)
  params : param list;  (** all modules; used like any definition of [groups], which they are *)
}

and param = {
  param : Global.t;  (** its definition is the value that it has by default *)
  given : Global.t option;
      (** the definition of the value that it is given from outside; its name is one that no source
          can mention *)
  span : Span.t;  (** of the name *)
}
(** [param x :: t = e]: fixed when a run starts. *)

and module_ = {
  name : string;
  file : string;
  library : bool;  (** from the standard library *)
  includes : string list;  (** the C headers it is written against *)
  idle_imports : idle list;
}

and idle = {
  of_module : string;
  listed : string option;
  at : Span.t;
  whole : Span.t;  (** what to take out: the line, or the name with a comma *)
}
(** An import of which the module uses nothing, or a name in its list. *)

(** {1 Types and units} *)

and type_declaration = {
  tycon : Global.t;
  unit_parameters : parameter list;
  type_parameters : parameter list;
  definition : type_definition;
  doc : string option;
  span : Span.t;
}

and parameter = { name : string; span : Span.t }

and type_definition =
  | Alias of ty
  | Data of constructor list  (** at least one *)
  | Builtin  (** Float, Int, Bool, String, Array, SF, Task, Program: no declaration in source *)
  | Foreign of { c_type : string; copyable : bool }

and constructor = {
  constructor : Global.t;
  tycon : Global.t;
  index : int;  (** among the type's constructors, from 0 *)
  fields : field list;
  record : bool;  (** fields have names *)
  span : Span.t;
}

and field = { field_name : string;  (** [""] if positional *) ty : ty; span : Span.t }
and ty = { desc : ty_desc; span : Span.t }

and ty_desc =
  | Type_variable of string  (** scope: the signature or declaration *)
  | Named of { tycon : Global.t; units : unit_ list; arguments : ty list }
      (** arity checked; [Float] alone has units [[]] and means [Float[1]] *)
  | Representation of { variable : string; unit_ : unit_ }  (** [n[u]] *)
  | Function of ty * ty
  | Tuple_type of ty list  (** none for [()] *)
  | Size of int  (** of an array; that it stands where a size does is typing's to check *)

and unit_ = { factors : (unit_factor * Syntax.Ir.rational) list; span : Span.t }
(** A product of powers, as written but flat. *)

and unit_factor = Declared of Global.t | Unit_variable of string
and unit_declaration = { unit_name : Global.t; definition : unit_definition; span : Span.t }
and unit_definition = Base | Scaled of Syntax.Ir.scale * unit_

and scheme = { context : constraint_ list; ty : ty; span : Span.t }
(** Variables are quantified unless an enclosing signature has them. *)

and constraint_ = { class_ : Global.t; argument : ty; span : Span.t }
(** The class is one of {!program.classes}, or [Prelude]'s [Eq] or [Ord], which are built in. *)

and primitive = {
  name : Global.t;
  scheme : scheme;
  foreign : foreign option;  (** none if the language has it built in *)
  doc : string option;
  span : Span.t;
}

and foreign = { kind : Syntax.Ir.foreign_kind; symbol : string  (** in C *) }

(** {1 Classes} *)

and class_ = {
  class_ : Global.t;
  variable : parameter;
  superclasses : (Global.t * Span.t) list;
  methods : method_ list;
  doc : string option;
  span : Span.t;
}

and method_ = {
  name : Global.t;  (** used like any other value *)
  scheme : scheme;  (** the class's variable is free in it; its own class is not in its context *)
  default : binding option;  (** its binder is the method's name *)
  doc : string option;
  span : Span.t;
}

and instance = {
  class_ : Global.t;
  context : constraint_ list;
  head : ty;
  definitions : (Global.t * binding) list;
      (** the methods given, each once; the binder is a name of its own that no source can mention
      *)
  span : Span.t;  (** of class and head *)
}

(** {1 Bindings} *)

and binding_group = { bindings : binding list; recursive : bool }
(** Mutually dependent bindings: a strongly connected component, where a reference to a binding with
    a signature makes no dependency. For what may call itself see the specializer: equations may,
    functions may not. *)

and binding = {
  name : binder;
  signature : scheme option;
  parameters : pattern list;  (** none for a plain value *)
  body : right;
  doc : string option;
  span : Span.t;
}

and binder =
  | Top of Global.t * Span.t
  | Inner of Local.t
  | Destructure of pattern
      (** [(x, y) = e], no parameters, no signature of its own; variables of the pattern may have
          entries in [signatures] of their declarations *)

and right = { guards : guarded list; where : declarations }
(** One [guarded] with [condition = None] for a plain right side. *)

and guarded = { condition : expr option; value : expr }

and declarations = {
  groups : binding_group list;  (** dependency order *)
  signatures : (Local.t * scheme) list;  (** of destructured variables *)
}

(** {1 Expressions} *)

and expr = { desc : expr_desc; span : Span.t }

and expr_desc =
  | Local of Local.t
  | Global of Global.t  (** a definition or a primitive *)
  | Constructor of Global.t
  | Number of number
  | String of string
  | Tuple of expr list
  | Array of expr list
  | Apply of { head : expr; argument : expr; style : apply_style }
      (** a function applied, or a signal function run: typing decides *)
  | Negate of expr
  | Power of { base : expr; exponent : int }
  | If of { condition : expr; then_ : expr; else_ : expr }
  | Case of { scrutinee : expr; branches : branch list }
  | Let of { declarations : declarations; body : expr }
  | Lambda of { parameters : pattern list; body : expr }
  | Proc of { input : pattern; body : proc_body }
  | Sequence of { statements : statement list; result : expr }  (** tasks, one after the other *)
  | Record of { constructor : Global.t; fields : (Syntax.Ir.name * expr) list }
      (** fields exist and are complete; order as written *)
  | Update of { record : expr; fields : (Syntax.Ir.name * expr) list; candidates : Global.t list }
  | Field of { record : expr; field : Syntax.Ir.name; candidates : Global.t list }
      (** [candidates]: the types in scope with such a field *)
  | Annotated of { expr : expr; scheme : scheme }

and apply_style =
  | Juxtaposed  (** [h x]: function or signal function *)
  | Operator of string  (** [a + b]; for messages *)
  | Command  (** [sf -< e]: the head must be a signal function *)

and number = { digits : string; decimal : bool; unit_ : unit_ option }
and branch = { pattern : pattern; right : right; span : Span.t }

and statement =
  | Task of { pattern : pattern option; task : expr }
      (** what it ends with is bound in all that follows, or dropped *)
  | Values of declarations

and proc_body = {
  equations : declarations;  (** a statement [p <- sf -< e] is the equation [p = run sf e] below *)
  output : expr;
}
(** All notations of a proc become this: the equations and the output. *)

(** {1 Patterns} *)

and pattern = { desc : pattern_desc; span : Span.t }

and pattern_desc =
  | Any
  | Bound of Local.t
  | As of Local.t * pattern
  | Tuple_of of pattern list
  | Array_of of pattern list  (** at least one *)
  | Constructed of Global.t * pattern list
      (** arity checked; record patterns have become positional, with [Any] *)
  | Literal of { negative : bool; number : number }
