(** The resolved form of a whole program with all its modules: names refer to declarations.

    Invariants (see {!Lint}): Every [Local] is bound exactly once and used within its scope. Every
    [Global], type, constructor and unit exists. Sections, [if] guards and operators have become
    applications and functions. Top-level groups are in dependency order, and so are local groups
    within their list. [proc], do-notation, patterns and fields keep their form, because later
    messages use the programmer's syntax. *)

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
  modules : module_ list;  (** dependencies before the modules that import them *)
  types : type_declaration list;  (** types of all modules, in dependency order *)
  units : unit_declaration list;  (** units of all modules, in dependency order *)
  primitives : primitive list;
  classes : class_ list;  (** classes of all modules, superclasses before subclasses *)
  instances : instance list;
  groups : binding_group list;  (** top-level groups of all modules, in dependency order *)
  params : param list;
      (** parameters of all modules; each is also an ordinary definition in [groups] *)
}

and param = {
  param : Global.t;  (** the definition of its default value *)
  given : Global.t option;
      (** the definition of the value that overrides the default, if there is one; its name cannot
          occur in source code *)
  span : Span.t;  (** span of the name *)
}
(** A parameter [param x :: t = e], whose value is fixed when a run starts. *)

and module_ = {
  name : string;
  file : string;
  library : bool;  (** whether the module is in the standard library *)
  includes : string list;  (** the C headers that its foreign declarations refer to *)
  idle_imports : idle list;
  imported : string list;  (** the modules whose names can all be used without a qualifier *)
  imports : string list;  (** all modules that it imports *)
  import_place : import_place;
}

and import_place = { place : Span.t; before : string; after : string }
(** The place at which to insert a new import, with the text before and after it. *)

and idle = {
  of_module : string;
  listed : string option;
  at : Span.t;
  whole : Span.t;  (** the text to remove: the line, or the name and a comma *)
}
(** An unused import, or an unused name in an import list. *)

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
  | Data of constructor list  (** at least one constructor *)
  | Builtin
      (** Float, Int, Bool, String, Array, SF, Task and Program; not declared in source code *)
  | Foreign of { c_type : string; copyable : bool }

and constructor = {
  constructor : Global.t;
  tycon : Global.t;
  index : int;  (** position among the type's constructors, from 0 *)
  fields : field list;
  record : bool;  (** whether the fields have names *)
  span : Span.t;
}

and field = { field_name : string;  (** [""] for a positional field *) ty : ty; span : Span.t }
and ty = { desc : ty_desc; span : Span.t }

and ty_desc =
  | Type_variable of string  (** bound by the enclosing signature or declaration *)
  | Named of { tycon : Global.t; units : unit_ list; arguments : ty list }
      (** has the right arity, except that [Float] may have [units = []], which means [Float[1]] *)
  | Representation of { variable : string; unit_ : unit_ }  (** [n[u]] *)
  | Function of ty * ty
  | Tuple_type of ty list  (** empty for [()] *)
  | Size of int  (** an array size; typing checks that it is used only where a size is allowed *)

and unit_ = { factors : (unit_factor * Syntax.Ir.rational) list; span : Span.t }
(** A flattened product of powers, in source order. *)

and unit_factor = Declared of Global.t | Unit_variable of string
and unit_declaration = { unit_name : Global.t; definition : unit_definition; span : Span.t }
and unit_definition = Base | Scaled of Syntax.Ir.scale * unit_

and scheme = { context : constraint_ list; ty : ty; span : Span.t }
(** Variables are quantified unless an enclosing signature binds them. *)

and constraint_ = { class_ : Global.t; argument : ty; span : Span.t }
(** The class is one of {!program.classes}, or the built-in [Eq] or [Ord] of [Prelude]. *)

and primitive = {
  name : Global.t;
  scheme : scheme;
  foreign : foreign option;  (** [None] for a built-in primitive *)
  doc : string option;
  span : Span.t;
}

and foreign = { kind : Syntax.Ir.foreign_kind; symbol : string  (** the name in C *) }

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
  name : Global.t;  (** usable in expressions like any other value *)
  scheme : scheme;
      (** the class variable is free in the scheme, and the scheme's context does not contain the
          class itself *)
  default : binding option;  (** its binder is the method's name *)
  doc : string option;
  span : Span.t;
}

and instance = {
  class_ : Global.t;
  context : constraint_ list;
  head : ty;
  definitions : (Global.t * binding) list;
      (** the methods that it defines, without duplicates; the binders are generated names that
          cannot occur in source code *)
  span : Span.t;  (** from the start of the class name to the end of the head *)
}

(** {1 Bindings} *)

and binding_group = { bindings : binding list; recursive : bool }
(** Mutually dependent bindings: a strongly connected component of the dependency graph. A reference
    to a binding with a signature does not count as a dependency. The specializer decides which
    recursion is allowed: equations may be recursive, functions may not. *)

and binding = {
  name : binder;
  signature : scheme option;
  parameters : pattern list;  (** empty for a plain value *)
  body : right;
  doc : string option;
  span : Span.t;
}

and binder =
  | Top of Global.t * Span.t
  | Inner of Local.t
  | Destructure of pattern
      (** [(x, y) = e]; it has neither parameters nor a signature, but its variables may have
          signatures, which are in {!declarations} *)

and right = { guards : guarded list; where : declarations }
(** A plain right-hand side is one [guarded] with [condition = None]. *)

and guarded = { condition : expr option; value : expr }

and declarations = {
  groups : binding_group list;  (** in dependency order *)
  signatures : (Local.t * scheme) list;  (** signatures of destructured variables *)
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
      (** a function application or a run of a signal function; typing distinguishes them *)
  | Negate of expr
  | Power of { base : expr; exponent : int }
  | If of { condition : expr; then_ : expr; else_ : expr }
  | Case of { scrutinee : expr; branches : branch list }
  | Let of { declarations : declarations; body : expr }
  | Lambda of { parameters : pattern list; body : expr }
  | Proc of { input : pattern; body : proc_body }
  | Sequence of { statements : statement list; result : expr }
      (** tasks that run one after the other *)
  | Record of { constructor : Global.t; fields : (Syntax.Ir.name * expr) list }
      (** all fields of the constructor, in source order *)
  | Update of { record : expr; fields : (Syntax.Ir.name * expr) list; candidates : Global.t list }
  | Field of { record : expr; field : Syntax.Ir.name; candidates : Global.t list }
      (** [candidates]: the record types in scope that have a field of this name *)
  | Annotated of { expr : expr; scheme : scheme }

and apply_style =
  | Juxtaposed  (** [h x]: function or signal function *)
  | Operator of string  (** [a + b]; for messages *)
  | Command  (** [sf -< e]: the head must be a signal function *)

and number = { digits : string; decimal : bool; unit_ : unit_ option }
and branch = { pattern : pattern; right : right; span : Span.t }

and statement =
  | Task of { pattern : pattern option; task : expr }
      (** the pattern binds the task's result in everything that follows; without a pattern, the
          result is discarded *)
  | Values of declarations

and proc_body = {
  equations : declarations;
      (** a statement [p <- sf -< e] becomes the equation [p = sf e], with an application of style
          [Command] *)
  output : expr;
}
(** The common form of all proc notations: equations and an output. *)

(** {1 Patterns} *)

and pattern = { desc : pattern_desc; span : Span.t }

and pattern_desc =
  | Any
  | Bound of Local.t
  | As of Local.t * pattern
  | Tuple_of of pattern list
  | Array_of of pattern list  (** at least one element *)
  | Constructed of Global.t * pattern list
      (** has the right arity; record patterns have become positional, with [Any] for missing fields
      *)
  | Literal of { negative : bool; number : number }
