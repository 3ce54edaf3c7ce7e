(** Core: small, explicitly typed, higher-order. What the reference interpreter runs and what the
    specializer evaluates.

    No longer there: units, patterns (tests and payloads instead), guards, records as such (data
    with one constructor), do-notation, arrow commands, anonymous instances: each run of a signal
    function is an equation of a proc; local functions that are polymorphic, and local signal
    functions and tasks that go on as themselves: they are definitions.

    Always true (see {!Lint}): every variable is bound once and in scope; types are closed over the
    type parameters of their definition; in a proc the order of equations has no meaning, and its
    [Run]s are the only instances; a [Payload] stands only where its constructor was tested;
    functions do not call themselves. *)

open Basis
module Local = Resolve.Ir.Local
module Global = Resolve.Ir.Global

type ty =
  | Variable of variable  (** a type, a size or a representation *)
  | Bool
  | Int
  | Float
  | String
  | Tuple of ty list  (** none for [()] *)
  | Function of ty * ty
  | Signal_function of ty * ty
  | Data of Global.t * ty list
  | Array of ty * ty  (** size and element *)
  | Size of int  (** at least 1; only where a size belongs *)

and variable = { id : int; name : string }

type program = {
  main_module : string;
  real : Real.t;  (** the precision of [Float] *)
  data : data list;  (** used before users *)
  instances : instance list;  (** at most one for each class and type constructor *)
  foreign : foreign;
  console : control list;  (** filled by {!Console.declare} *)
  definitions : definition list;  (** dependency order *)
  params : param list;
}

and param = {
  param : Global.t;  (** a definition: of the value that it has by default *)
  given : Global.t option;  (** that of the value that it is given from outside *)
  label : string;  (** what it is called outside of the program: [k], or [M.k] *)
  ty : ty;  (** [Bool], [Int] or [Float] *)
  unit_ : string;  (** as it is written in brackets: [1/m]; [1]; [""] of a [Bool] *)
  doc : string option;
  span : Span.t;  (** of its name *)
}
(** A parameter of the program: what mentions it mentions a [Global]. *)

and control = {
  label : string;
  kind : control_kind;
  unit_ : string;  (** of a knob: [m/s]; [""] without one, or if it is open *)
  span : Span.t;  (** where the program asks for it *)
}
(** What stands on the operator's console, under a label that nothing else there has. *)

and control_kind =
  | Button  (** pressed: an event of [()] *)
  | Hold  (** a button that is held down: a Bool *)
  | Knob of { least : float; most : float; first : float }
  | Toggle of { first : bool }
  | Map  (** a click there: an event of a place, in metres *)
  | Camera  (** an event of a frame *)
  | Tags  (** an event of the tags in a frame *)

and foreign = {
  headers : header list;
  types : foreign_type list;  (** also data without constructors *)
  values : (Primitive.foreign * ty) list;
      (** [Function]s or a [Signal_function] of closed first-order types *)
}
(** What is C code of the user's. *)

and header = { header : string; of_file : string  (** its path is from that file's folder *) }

and foreign_type = {
  foreign_type : Global.t;
  c_type : string;
  copyable : bool;  (** else a value lives for the instant, and is never copied *)
}

and instance = {
  class_ : Global.t;
  head : ty;  (** a type constructor applied to distinct variables *)
  methods : (string * implementation) list;  (** all of the class's *)
}

and implementation =
  | Given of Global.t
      (** a definition whose parameters begin with the head's variables, in order *)
  | Default of Global.t  (** a definition whose parameters begin with the class's variable *)

and data = {
  tycon : Global.t;
  parameters : variable list;
  constructors : constructor list;
  span : Span.t;
}

and constructor = {
  name : Global.t;
  record : bool;
  fields : (string * ty) list;  (** [""] if positional *)
}

and definition = {
  name : Global.t;
  parameters : variable list;
  ty : ty;
  body : expr;
  span : Span.t;
}

and binder = { local : Local.t; ty : ty }
and expr = { desc : expr_desc; ty : ty; span : Span.t }

and expr_desc =
  | Local of Local.t
  | Global of Global.t * ty list
  | Primitive of Primitive.t * ty list
  | Method of { class_ : Global.t; name : string; ty : ty; types : ty list }
      (** of the instance for [ty]; [types]: for the method's own parameters. [ty] is a variable:
          where its constructor is known the instance's definition stands itself, as a [Global] *)
  | Number of Exact.t  (** of type Int, Float or a representation variable *)
  | Boolean of bool
  | String of string
  | Lambda of binder * expr
  | Apply of expr * expr
  | Let of { binder : binder; value : expr; body : expr }  (** not recursive *)
  | Tuple of expr list
  | Component of expr * int  (** of a tuple, from 0 *)
  | Array of expr list  (** at least one *)
  | Index of expr * int
      (** the element of that number, from 0; inside, if the size is known here *)
  | Construct of { data : Global.t; constructor : int; arguments : expr list }
      (** saturated; Bool has its own constants *)
  | Is_constructor of expr * int  (** a Bool; the data type is [expr]'s *)
  | Payload of { value : expr; constructor : int; field : int }
  | If of expr * expr * expr
  | Proc of proc

and proc = {
  name : string;  (** the definition it belongs to: names in the C code *)
  input : binder;
  equations : equation list;
  output : expr;
}

and equation = { binder : binder; rhs : rhs; span : Span.t }

and rhs =
  | Pure of expr  (** holds at every instant: a signal, a static value or a local function *)
  | Run of { signal_function : expr; input : expr }  (** an instance of a static signal function *)
