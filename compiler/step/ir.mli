(** Step: each node as a struct of state, a reset and a step function, made of statements with
    expression trees.

    No longer there: the freedom of order. Equations have become statements in an order in which
    everything is written before it is read; an unnamed value used once stands inside its user's
    expression; what only one branch needs is computed in that branch; a delay is a field that is
    written at the end of the step.

    Always true (see {!Lint}): a variable is declared once in its function, before its uses and in a
    block around them; both branches assign what an [If] leaves uninitialized before it; nodes call
    only nodes before them; nesting of statements and expressions is bounded ({!Placement.nesting},
    {!Usage.expression_size}), whatever the program. *)

open Basis

type ty =
  | Bool
  | Int
  | Float
  | Sum of int  (** index into [program.sums] *)
  | Array of int * ty  (** size and element *)
  | Nanoseconds  (** 64 bits, not negative *)
  | Foreign of Flow.Ir.foreign_type

type variable = {
  id : int;  (** unique in the function *)
  name : string;  (** the programmer's, or [""] *)
  ty : ty;
}

type field = {
  id : int;  (** unique in the node *)
  name : string;  (** from the source; not always unique *)
  content : content;
  purpose : string;  (** for the reader: [delay], [integral], a callee's name *)
  span : Span.t;
}
(** A member of a node's state. *)

and content =
  | Value of ty
  | State_of of int  (** of that node *)
  | States_of of { node : int; count : int }  (** one for each round of a loop *)
  | Running_mode  (** the number of a mode *)
  | Modes of mode list  (** room for what any one of them keeps *)
  | Component of string  (** the state of the user's C of that name *)

and mode = {
  node : int;
  name : string;  (** unique in the program *)
  parameters : (variable * field) list;  (** those of the mode's parameters that its step reads *)
  state : field option;  (** if the mode's node has state *)
}
(** What a machine keeps while this mode runs. *)

type expr =
  | Bool of bool
  | Int of int32
  | Float of float
  | Zero_time  (** no nanoseconds *)
  | Absent of Flow.Ir.foreign_type  (** no value, which nothing looks at *)
  | Variable of variable
  | Field of field  (** of the node's own state *)
  | Param of int  (** of [program.params] *)
  | Dt  (** seconds since the previous instant; 0 at a node's first *)
  | Dt_nanoseconds
  | Operation of { operator : Flow.Ir.operator; ty : ty; arguments : expr list }
      (** [ty] is that of the arguments *)
  | Select of { condition : expr; then_ : expr; else_ : expr }
  | Construct of { sum : int; constructor : int; payload : expr list }
  | Is_constructor of { sum : int; value : expr; constructor : int }
  | Payload of { sum : int; value : expr; constructor : int; leaf : int }
  | Elements of { element : ty; elements : expr list }
      (** an array; only as the whole value of a [Declare] *)
  | Fill of { count : int; element : ty; value : expr }
  | Index of { array : expr; index : int }  (** inside *)
  | At of { count : int; element : ty; array : expr; index : expr; default : expr }
  | Replace of { count : int; element : ty; array : expr; index : expr; value : expr }
  | Call of { node : int; arguments : expr list }
      (** of a node without state and with one output *)
  | Seconds of expr  (** of [Nanoseconds] *)
  | In_nanoseconds of expr  (** likewise, as a Float: see {!Flow.Clock} *)
  | Later of expr * expr  (** the sum of two [Nanoseconds], saturating *)
  | Soon of expr * expr  (** likewise, if it is known to be far from where that saturates *)
  | Reached of { time : expr; period : expr }
      (** are these [Nanoseconds] at least so many? A Float, whose fraction is dropped *)
  | Rest of { time : expr; period : expr }
      (** what is left of [Nanoseconds] that have [Reached] it after as many whole periods as there
          are; 0 if it is less than 1 *)

type place = Local of variable | Own of field | Result of int  (** an output of the function *)

type statement =
  | Declare of { variable : variable; value : expr; span : Span.t }  (** a constant *)
  | Assign of { place : place; value : expr; span : Span.t }
  | If of {
      uninitialized : variable list;  (** declared here for both branches *)
      condition : expr;
      then_ : statement list;
      else_ : statement list;
      predicted : bool;  (** worth a branch of the machine, not a select: see {!Feedback} *)
      span : Span.t;
    }
  | Step of {
      node : int;
      state : field option;  (** [None] if the node has no state *)
      arguments : expr list;
      results : variable list;  (** declared here *)
      on_trial : bool;  (** of a copy of the state, which is then forgotten *)
      span : Span.t;
    }
  | Loop of loop
  | Reset of { node : int; state : field; arguments : expr list; span : Span.t }
      (** of all states that the field holds *)
  | Enter of { entry : entry; span : Span.t }
  | Run of run
  | Return of { value : expr; span : Span.t }  (** last; one output only *)

and loop = {
  node : int;
  state : field option;
  count : int;
  initial : expr list;  (** of the accumulators *)
  arguments : argument list;  (** of the node's step *)
  results : variable list;  (** declared here: accumulators, then arrays *)
  span : Span.t;
}
(** The step of a node, round after round. *)

and argument =
  | Accumulated of int  (** the accumulator of that number *)
  | Each of expr  (** of an array *)
  | Same of expr
  | Counted of expr  (** that, and one more in each round *)

and entry = {
  mode : int;  (** of the node's [modes] *)
  parameters : expr list;  (** for the mode's [parameters] *)
  arguments : expr list;  (** of its node's [reset] *)
}
(** A mode begins: its parameters, then its state. *)

and run = {
  active : expr option;  (** if it does not hold, nothing runs, and the results are any *)
  clock : clock option;  (** with [active], if a mode looks at dt *)
  steps : int;  (** at most so many modes are stepped *)
  controls : (expr * entry) list;  (** the first that holds *)
  late : bool;  (** they come after the mode that runs, not before *)
  drops : bool;  (** after a late control or a delayed transition the modes' results are dropped *)
  cases : case list;  (** one for each mode *)
  results : variable list;  (** declared here *)
  span : Span.t;
}
(** One instant of the node's machine (see {!Flow.Ir.machine}). In what comes after an entry, dt is
    0. *)

and clock = {
  since : field;
  running : field;  (** a Bool: past the first *)
  elapsed : expr;  (** [since] and this instant's *)
}
(** The time since a machine's own last instant, 0 up to its first. *)

and case = {
  arguments : expr list;  (** of the step of the mode's node *)
  others : variable list;  (** what the step gives after the machine's results, declared here *)
  transitions : next list;  (** the first that holds *)
}

and next = {
  condition : expr;
  entry : entry;
  delayed : bool;
  at_entry : Flow.Ir.at_entry;
  span : Span.t;
}

type code = {
  parameters : variable list;
      (** only those it reads; of the root's step: all leaves of the input *)
  body : statement list;
}

type node = {
  name : string;  (** unique in the program *)
  origin : string;  (** the definition as the programmer knows it *)
  file : string;
  span : Span.t;
  state : field list;  (** after all passes in the order of the struct: {!Field_order} *)
  modes : mode list;  (** of its machine, if there is one *)
  foreign : Flow.Ir.foreign option;
      (** its step and reset are the user's C; [reset] and [step] have no body, and its state, if
          any, is one [Component] *)
  reset : code;  (** empty if there is no state, or nothing calls it *)
  step : code;
  outputs : (string * ty) list;  (** then what only transitions read *)
  ends_early : int option;
      (** a mode whose step, where one of its transitions occurs, gives only the outputs from this
          number on: see {!Early_end} *)
  seconds : bool;  (** the step, or a callee's, reads [Dt] *)
  nanoseconds : bool;  (** likewise [Dt_nanoseconds] *)
  operations : int;  (** a rough count of the step's own, without callees *)
}

type mark = {
  field : field;
  own : bool;  (** the step sets it at once; else it does so last, as any delay *)
}
(** A Bool of the root, false up to the first step. *)

type program = {
  name : string;  (** of the C files *)
  real : Real.t;  (** the precision of [Float] *)
  sums : Flow.Ir.sum array;
  nodes : node array;  (** callees before callers; the last is the root *)
  imports : Flow.Ir.import list;
  headers : Flow.Ir.header list;  (** of the user's C *)
  input : Flow.Ir.shape;
  console : Core.Ir.control list;  (** as {!Flow.Ir.program} *)
  output : Flow.Ir.shape;
  ends : bool;  (** as {!Flow.Ir.program} *)
  probes : (string * Flow.Ir.shape) list;  (** likewise *)
  claims : Flow.Ir.claim list;  (** likewise *)
  marks : int;  (** likewise *)
  params : Flow.Ir.param list;
  started : mark option;
      (** there if the dt of the first instant can be seen, and so must be made 0 *)
}
