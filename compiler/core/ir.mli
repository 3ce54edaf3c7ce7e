(** Core: a small, explicitly typed, higher-order language. The reference interpreter runs it, and
    the specializer evaluates it.

    Core does not have units, guards, do-notation, arrow commands or anonymous instances: each run
    of a signal function is an equation of a proc. Tests and payloads replace patterns, and data
    types with one constructor replace records. Polymorphic local functions, and recursive local
    signal functions and tasks, have become top-level definitions.

    Invariants (see {!Lint}): Every variable is bound once and used in scope. Types mention only the
    type parameters of their definition. The order of a proc's equations is irrelevant, and their
    [Run]s are the only instances. A [Payload] occurs only where its constructor has been tested.
    Functions are not recursive. *)

open Basis
module Local = Resolve.Ir.Local
module Global = Resolve.Ir.Global

type ty =
  | Variable of variable  (** a type, size or representation variable *)
  | Bool
  | Int
  | Float
  | String
  | Tuple of ty list  (** empty for [()] *)
  | Function of ty * ty
  | Signal_function of ty * ty
  | Data of Global.t * ty list
  | Array of ty * ty  (** size and element type *)
  | Size of int  (** at least 1; only where a size is expected *)

and variable = { id : int; name : string }

type program = {
  main_module : string;
  real : Real.t;  (** the precision of [Float] *)
  data : data list;  (** in dependency order *)
  instances : instance list;  (** at most one for each pair of a class and a type constructor *)
  foreign : foreign;
  console : control list;  (** set by {!Console.declare} *)
  definitions : definition list;  (** in dependency order *)
  params : param list;
}

and param = {
  param : Global.t;  (** the definition of its default value *)
  given : Global.t option;
      (** the definition of the value that overrides the default, if the command line sets one *)
  label : string;  (** its name for users: [k], or [M.k] *)
  ty : ty;  (** [Bool], [Int] or [Float] *)
  unit_ : string;  (** the unit as written in brackets, such as [1/m] or [1]; [""] for a [Bool] *)
  doc : string option;
  span : Span.t;  (** the span of its name *)
}
(** A parameter of the program. Expressions refer to it as a [Global]. *)

and control = {
  label : string;
  kind : control_kind;
  unit_ : string;
      (** the unit of a knob, for example [m/s]; [""] if there is none or it is undetermined *)
  span : Span.t;  (** the place where the program requests it *)
}
(** A control on the operator's console, with a unique label. *)

and control_kind =
  | Button  (** an event of type [()] that occurs when the button is pressed *)
  | Hold  (** a Bool that is True while the button is held down *)
  | Knob of { least : float; most : float; first : float }
  | Toggle of { first : bool }
  | Map  (** an event with the position of a click, in metres *)
  | Camera  (** an event with a camera frame *)
  | Tags  (** an event with the tags detected in a frame *)
  | Lidar of { rays : int }  (** an event with a scan, resampled to this number of directions *)
  | Imu  (** an event with the reading of an inertial measurement unit *)

and foreign = {
  headers : header list;
  types : foreign_type list;  (** including opaque types, which have no constructors *)
  values : (Primitive.foreign * ty) list;
      (** each has a curried [Function] or [Signal_function] type over closed first-order types *)
}
(** Declarations of the user's own C code. *)

and header = {
  header : string;
  of_file : string;
      (** the file that declares the header; the header's path is relative to that file's folder *)
}

and foreign_type = {
  foreign_type : Global.t;
  c_type : string;
  copyable : bool;  (** if false, a value lives only for one instant and is never copied *)
}

and instance = {
  class_ : Global.t;
  head : ty;  (** a type constructor applied to distinct variables *)
  methods : (string * implementation) list;  (** all methods of the class *)
}

and implementation =
  | Given of Global.t
      (** a definition whose type parameters begin with the head's variables, in order *)
  | Default of Global.t  (** a definition whose type parameters begin with the class's variable *)

and data = {
  tycon : Global.t;
  parameters : variable list;
  constructors : constructor list;
  span : Span.t;
}

and constructor = {
  name : Global.t;
  record : bool;
  fields : (string * ty) list;  (** the name is [""] for a positional field *)
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
      (** the method of the instance for [ty], which is a type variable. (For a known type
          constructor, a [Global] refers directly to the instance's definition.) [types]: the
          arguments for the method's own parameters *)
  | Number of Exact.t  (** has type Int, Float or a representation variable *)
  | Boolean of bool
  | String of string
  | Lambda of binder * expr
  | Apply of expr * expr
  | Let of { binder : binder; value : expr; body : expr }  (** not recursive *)
  | Tuple of expr list
  | Component of expr * int  (** a component of a tuple, counted from 0 *)
  | Array of expr list  (** at least one element *)
  | Index of expr * int
      (** the element at this index, counted from 0; the index is within bounds if the size is known
          here *)
  | Construct of { data : Global.t; constructor : int; arguments : expr list }
      (** all arguments are present; Bool has its own constants *)
  | Is_constructor of expr * int  (** a Bool; the type of [expr] determines the data type *)
  | Payload of { value : expr; constructor : int; field : int }
  | If of expr * expr * expr
  | Proc of proc

and proc = {
  name : string;  (** the definition that it belongs to, for names in the C code *)
  input : binder;
  equations : equation list;
  output : expr;
}

and equation = { binder : binder; rhs : rhs; span : Span.t }

and rhs =
  | Pure of expr
      (** an equation that holds at every instant and defines a signal, a static value or a local
          function *)
  | Run of { signal_function : expr; input : expr }
      (** an equation that runs an instance of a static signal function *)
