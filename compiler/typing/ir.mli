(** Typed: the resolved program with a type for every expression.

    Type information settles whether a juxtaposition applies a function or runs a signal function,
    which record a field belongs to, how a literal is represented, and at which types a polymorphic
    name is used.

    Invariants (see {!Lint}): Types mention only the type parameters of the enclosing definition.
    Undetermined types have their defaults. Levels satisfy section 2 of the language reference: only
    static signal functions are run, and instances occur only where they run at every instant. Cases
    are exhaustive. Units agree; they stay in the types only for messages, dumps and documentation.
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
  | Tuple of ty list  (** empty for [()] *)
  | Function of ty * ty
  | Signal_function of ty * ty
  | Data of { tycon : Global.t; units : unit_ list; arguments : ty list }
      (** including [Array n a] and [Program i o], which have no constructors *)
  | Size of int  (** array size, at least 1; occurs only as an argument of [Data] *)

and variable = { id : int; name : string }
(** A quantified variable that ranges over types, sizes, representations or units. *)

and representation = Int | Float | Representation_variable of variable

and unit_ = {
  base : (Global.t * Syntax.Ir.rational) list;  (** powers of base units; sorted, no zero powers *)
  variables : (variable * Syntax.Ir.rational) list;  (** sorted, no zero powers *)
}

and scheme = {
  types : variable list;  (** quantified type and size variables *)
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
  data : data list;  (** in dependency order *)
  primitives : (Global.t * scheme) list;  (** including the foreign ones *)
  foreign : foreign;
  classes : class_declaration list;  (** superclasses before subclasses *)
  instances : instance list;  (** at most one for each pair of a class and a type constructor *)
  definitions : definition list;
      (** top-level definitions in dependency order, followed by methods *)
  params : param list;
}

and param = {
  param : Global.t;  (** the definition of its default value *)
  given : Global.t option;
      (** the definition of the value that overrides the default, if there is one *)
  ty : ty;  (** a [Number] without variables, or [Bool] *)
  doc : string option;
  span : Span.t;  (** span of the name *)
}
(** A parameter: a static value fixed when a run starts, and unknown to the compiler. *)

and foreign = {
  headers : header list;
  foreign_types : foreign_type list;  (** including opaque types, which have no constructors *)
  values : foreign_value list;
}
(** Declarations of the user's own C code. *)

and header = {
  header : string;
  of_file : string;  (** the path in [header] is relative to the folder of this file *)
}

and foreign_type = { tycon : Global.t; c_type : string; copyable : bool }

and foreign_value = {
  name : Global.t;
  kind : Syntax.Ir.foreign_kind;
  symbol : string;  (** the C name *)
  ty : ty;
      (** a [Function] with at least one argument or a [Signal_function]; its first-order parts
          contain no variables except unit variables *)
  span : Span.t;
}

and class_declaration = {
  class_ : Global.t;
  methods : (Global.t * scheme) list;
      (** the class's type variable is the first one in the scheme, and the class itself is the
          first constraint in the context *)
}

and instance = {
  class_ : Global.t;
  parameters : variable list;
  head : ty;  (** a type constructor applied to the instance's parameters and to units *)
  methods : (Global.t * implementation) list;  (** all methods of the class, in declaration order *)
  span : Span.t;
}

and implementation =
  | Given of Global.t
      (** a definition with the type parameters of the instance, followed by those of the method *)
  | Default of Global.t
      (** the class's default definition, with the method's name and type parameters *)

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
  fields : (string * ty) list;  (** the name is [""] for a positional field *)
}

and definition = {
  name : Global.t;
  scheme : scheme;
  needs : need list;  (** one for each constraint in the scheme's context, in order *)
  value : expr;  (** parameters are converted to [Lambda] *)
  doc : string option;
  span : Span.t;
}

and need = { place : Span.t; by : string }
(** The code outside the library that first requires a class. If definitions pass the requirement
    on, this is the code closest to the class's method. [by]: the name or the instance that requires
    the class, in backticks. *)

(** {1 Expressions} *)

and expr = { desc : expr_desc; ty : ty; span : Span.t }

and expr_desc =
  | Local of Local.t * instantiation
  | Global of Global.t * instantiation
  | Primitive of Global.t * instantiation
  | Method of { class_ : Global.t; method_ : Global.t; instantiation : instantiation }
      (** the first type argument selects the instance *)
  | Constructor of constructor * Global.t
      (** the constructor as a function of its fields, with the type of this function *)
  | Number of Exact.t
      (** the exact value in base units. Specialization rounds it once, to the representation of its
          type. If the type is [Int] or a variable, the value is an integer in range *)
  | String of string
  | Tuple of expr list
  | Array of expr list  (** at least one element *)
  | Index of expr * int  (** [a ! k]; if the size is known here, [k] is a valid index *)
  | Apply of expr * expr  (** a pointwise function application *)
  | Run of expr * expr  (** runs an instance of a signal function on an input signal *)
  | Negate of expr
  | Power of expr * int
  | If of expr * expr * expr
  | Case of expr * branch list
  | Let of binding list * expr
      (** in dependency order; in a recursive group, signal functions and tasks, and functions that
          return them, may be used before their definition *)
  | Lambda of pattern list * expr
  | Guards of (expr * expr) list * expr option
      (** selects the value of the first guard that is true, otherwise the last expression. If that
          is [None] (only inside a [Case]), continues with the next branch *)
  | Proc of { input : pattern; equations : binding list; output : expr }
  | Record of constructor * (int * expr) list  (** all fields, in the order written *)
  | Update of expr * constructor * (int * expr) list
  | Field of expr * constructor * int

and instantiation = { types : ty list; representations : representation list }
(** The type arguments for the scheme's quantified variables, in order. Units are erased. *)

and branch = { pattern : pattern; value : expr }

and binding = {
  pattern : pattern;  (** [Bound] for a plain name or a function *)
  scheme : scheme;  (** polymorphic only for local functions with a signature *)
  value : expr;
  recursive : bool;  (** refers to itself, directly or through other bindings in the same list *)
  level : level;
  span : Span.t;
}
(** In a proc: an equation, a static value or a local function. *)

and level = Constant | Static  (** known when the enclosing signal function starts *) | Signal

(** {1 Patterns} *)

and pattern = { desc : pattern_desc; ty : ty; span : Span.t }

and pattern_desc =
  | Any
  | Bound of Local.t
  | As of Local.t * pattern
  | Tuple_of of pattern list
  | Array_of of pattern list  (** at least one element *)
  | Constructed of constructor * pattern list
  | Literal of Exact.t
