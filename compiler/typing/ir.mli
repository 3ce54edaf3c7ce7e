(** Typed: the resolved program with the type of everything, and with what only types can decide
    decided: whether a juxtaposition applies a function or runs a signal function, which record a
    field belongs to, how a literal is represented, at which types a polymorphic name is used.

    Always true (see {!Lint}): types are closed over the type parameters of the enclosing
    definition; what nothing decided has its default; levels are as the language reference, section
    2, demands: what is run is static, instances stand only where they run at every instant; cases
    are exhaustive; units agree (and stay in the types only for messages, dumps and documentation).
*)

open Basis
module Local = Resolve.Ir.Local
module Global = Resolve.Ir.Global

(** {1 Types} *)

type ty =
  | Variable of variable
  | Number of representation * unit_
  | Bool
  | String
  | Tuple of ty list  (** none for [()] *)
  | Function of ty * ty
  | Signal_function of ty * ty
  | Data of { tycon : Global.t; units : unit_ list; arguments : ty list }
      (** also [Array n a] and [Program i o], data without constructors *)
  | Size of int  (** of an array, at least 1; only as an argument of [Data] *)

and variable = { id : int; name : string }
(** A quantified variable of a type, size, representation or unit. *)

and representation = Int | Float | Representation_variable of variable

and unit_ = {
  base : (Global.t * Syntax.Ir.rational) list;  (** base units; sorted, no zero powers *)
  variables : (variable * Syntax.Ir.rational) list;  (** likewise *)
}

and scheme = {
  types : variable list;  (** quantified, sizes among them *)
  representations : variable list;
  units : variable list;
  context : (class_ * ty) list;
  ty : ty;
}

and class_ = Eq | Ord | Declared of Global.t

(** {1 Programs} *)

type program = {
  main_module : string;
  real : Real.t;  (** the precision of [Float] *)
  data : data list;  (** used before users *)
  primitives : (Global.t * scheme) list;  (** the foreign ones among them *)
  foreign : foreign;
  classes : class_declaration list;  (** superclasses before their subclasses *)
  instances : instance list;  (** at most one for each class and type constructor *)
  definitions : definition list;  (** top level, dependency order; after them those of methods *)
  params : param list;
}

and param = {
  param : Global.t;  (** a definition: of the value that it has by default *)
  given : Global.t option;  (** that of the value that it is given from outside *)
  ty : ty;  (** a [Number] without variables, or [Bool] *)
  doc : string option;
  span : Span.t;  (** of the name *)
}
(** Static, and fixed when a run starts: no value of it is known to the compiler. *)

and foreign = {
  headers : header list;
  foreign_types : foreign_type list;  (** also data without constructors *)
  values : foreign_value list;
}
(** What is C code of the user's. *)

and header = { header : string; of_file : string  (** its path is from that file's folder *) }
and foreign_type = { tycon : Global.t; c_type : string; copyable : bool }

and foreign_value = {
  name : Global.t;
  kind : Syntax.Ir.foreign_kind;
  symbol : string;  (** in C *)
  ty : ty;
      (** [Function]s of at least one argument, or a [Signal_function], of first-order types without
          variables, but for units *)
  span : Span.t;
}

and class_declaration = {
  class_ : Global.t;
  methods : (Global.t * scheme) list;
      (** the class's variable comes first, its own class first in the context *)
}

and instance = {
  class_ : Global.t;
  parameters : variable list;
  head : ty;  (** a type constructor applied to the parameters and to units *)
  methods : (Global.t * implementation) list;  (** all of the class's, in its order *)
  span : Span.t;
}

and implementation =
  | Given of Global.t
      (** a definition whose type parameters are those of the instance, then the method's own *)
  | Default of Global.t
      (** the class's definition, which has the method's name and type parameters *)

and data = {
  tycon : Global.t;
  unit_parameters : variable list;
  type_parameters : variable list;
  constructors : constructor list;
  span : Span.t;
}

and constructor = {
  constructor : Global.t;
  index : int;
  record : bool;
  fields : (string * ty) list;  (** [""] if positional *)
}

and definition = {
  name : Global.t;
  scheme : scheme;
  needs : need list;  (** of the scheme's context, in its order *)
  value : expr;  (** parameters have become [Lambda] *)
  doc : string option;
  span : Span.t;
}

and need = { place : Span.t; by : string }
(** What in the program, outside of the library, asks for a class, as near to the class's method as
    can be; [by] says it, in backticks. *)

(** {1 Expressions} *)

and expr = { desc : expr_desc; ty : ty; span : Span.t }

and expr_desc =
  | Local of Local.t * instantiation
  | Global of Global.t * instantiation
  | Primitive of Global.t * instantiation
  | Method of { class_ : Global.t; method_ : Global.t; instantiation : instantiation }
      (** the first type is the one whose instance is used *)
  | Constructor of constructor * Global.t  (** as a function of its fields; its type *)
  | Number of Exact.t
      (** the exact value in base units; rounded once, to the representation that the type says (an
          integer in range if that is [Int] or a variable) *)
  | String of string
  | Tuple of expr list
  | Array of expr list  (** at least one *)
  | Index of expr * int  (** [a ! k], inside the array if its size is known here *)
  | Apply of expr * expr  (** function to argument, pointwise *)
  | Run of expr * expr  (** an instance of a signal function, on a signal *)
  | Negate of expr
  | Power of expr * int
  | If of expr * expr * expr
  | Case of expr * branch list
  | Let of binding list * expr
      (** dependency order; in a circle signal functions and tasks, and functions that give such,
          may be used before they are defined *)
  | Lambda of pattern list * expr
  | Guards of (expr * expr) list * expr option
      (** first guard that holds; [None]: falls through to the next branch of the enclosing [Case]
          (only there) *)
  | Proc of { input : pattern; equations : binding list; output : expr }
  | Record of constructor * (int * expr) list  (** complete, order as written *)
  | Update of expr * constructor * (int * expr) list
  | Field of expr * constructor * int

and instantiation = { types : ty list; representations : representation list }
(** For the quantified variables of the scheme, in their order; units are erased. *)

and branch = { pattern : pattern; value : expr }

and binding = {
  pattern : pattern;  (** [Bound] for a plain name or a function *)
  scheme : scheme;  (** polymorphic only for local functions with a signature *)
  value : expr;
  recursive : bool;  (** it uses itself, maybe through others of its list *)
  level : level;
  span : Span.t;
}
(** In a proc: an equation, a static value or a local function. *)

and level = Constant | Static  (** known when the signal function around it starts *) | Signal

(** {1 Patterns} *)

and pattern = { desc : pattern_desc; ty : ty; span : Span.t }

and pattern_desc =
  | Any
  | Bound of Local.t
  | As of Local.t * pattern
  | Tuple_of of pattern list
  | Array_of of pattern list  (** at least one *)
  | Constructed of constructor * pattern list
  | Literal of Exact.t
