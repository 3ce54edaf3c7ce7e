(** Step: each node is a state struct with a reset and a step function. The functions consist of
    statements and expression trees.

    In this language, the order of evaluation is fixed. Equations have become statements, ordered so
    that everything is written before it is read. An unnamed value that is used once is part of the
    expression that uses it. Values that only one branch needs are computed in that branch. A delay
    is a field that is written at the end of the step.

    Invariants (see {!Lint}): a variable is declared once in its function, before its uses and in a
    block that contains them; variables that an [If] declares uninitialized are assigned in both
    branches; nodes call only preceding nodes; the nesting depth of statements and expressions is
    bounded ({!Placement.nesting}, {!Usage.expression_size}) for all programs. *)

open Basis

type ty =
  | Bool
  | Int
  | Float
  | Sum of int  (** index into [program.sums] *)
  | Array of int * ty  (** size and element *)
  | Nanoseconds  (** non-negative 64-bit integer *)
  | Foreign of Flow.Ir.foreign_type

type variable = {
  id : int;  (** unique in the function *)
  name : string;  (** the programmer's name, or [""] *)
  ty : ty;
}

type field = {
  id : int;  (** unique in the node *)
  name : string;  (** a name from the source, which may occur several times *)
  content : content;
  bound : int64 option;
      (** for [Nanoseconds]: if present, the field has 32 bits, and the time that [Later] returns
          for it never exceeds this number (see {!Short_times}) *)
  purpose : string;
      (** purpose of the field, for readers of the generated C: [delay], [integral], or a callee's
          name *)
  origin : origin option;  (** the signal whose values the field stores, if any *)
  span : Span.t;
}
(** A member of a node's state. *)

and origin = { signal : string; written : Span.t; role : role }
(** A signal of Flow: its name, or [""], and its place in the source. *)

(** How the value of the field relates to this signal. *)
and role =
  | Its_value
  | Its_integrand  (** the signal is an integral *)
  | Its_integral  (** the signal is a derivative *)

and content =
  | Value of ty
  | State_of of int  (** the state of this node *)
  | States_of of { node : int; count : int }  (** one state for each iteration of a loop *)
  | Running_mode  (** the number of the running mode *)
  | Modes of mode list  (** a union of the states of these modes *)
  | Component of string  (** the state of the user's C component with this name *)

and mode = {
  node : int;
  name : string;  (** unique in the program *)
  parameters : (variable * field) list;
      (** the parameters that the mode's step reads, with their fields *)
  state : field option;  (** present if the mode's node has state *)
}
(** The state of a machine while this mode runs. *)

type expr =
  | Bool of bool
  | Int of int32
  | Float of float
  | Zero_time  (** 0 nanoseconds *)
  | Absent of Flow.Ir.foreign_type  (** a placeholder for a missing value; it is never read *)
  | Variable of variable
  | Field of field  (** a field of the node's own state *)
  | Param of int  (** an element of [program.params] *)
  | Dt  (** seconds since the previous instant; 0 in the first instant of a node *)
  | Dt_nanoseconds
  | Operation of { operator : Flow.Ir.operator; ty : ty; arguments : expr list; span : Span.t }
      (** [ty] is the type of the arguments *)
  | Select of { condition : expr; then_ : expr; else_ : expr; span : Span.t }
  | Construct of { sum : int; constructor : int; payload : expr list }
  | Is_constructor of { sum : int; value : expr; constructor : int }
  | Payload of { sum : int; value : expr; constructor : int; leaf : int }
  | Elements of { element : ty; elements : expr list }
      (** an array; only allowed as the whole value of a [Declare] *)
  | Fill of { count : int; element : ty; value : expr }
  | Index of { array : expr; index : int }  (** the index is within bounds *)
  | At of { count : int; element : ty; array : expr; index : expr; default : expr }
  | Replace of { count : int; element : ty; array : expr; index : expr; value : expr }
  | Call of { node : int; arguments : expr list }  (** calls a stateless node with one output *)
  | Seconds of expr  (** converts [Nanoseconds] to seconds *)
  | In_nanoseconds of expr  (** converts [Nanoseconds] to a Float; see {!Flow.Clock} *)
  | Later of expr * expr  (** the saturating sum of two [Nanoseconds] *)
  | Soon of expr * expr  (** the sum of two [Nanoseconds], which cannot overflow *)
  | Reached of { time : expr; period : expr }
      (** whether the [Nanoseconds] are at least this Float, truncated to an integer *)
  | Rest of { time : expr; period : expr }
      (** the [Nanoseconds] modulo the period, used only if they have [Reached] it; 0 if the period
          is less than 1 *)

type place = Local of variable | Own of field | Result of int  (** an output of the function *)

type statement =
  | Declare of { variable : variable; value : expr; span : Span.t }  (** a constant *)
  | Assign of { place : place; value : expr; span : Span.t }
  | If of {
      uninitialized : variable list;  (** variables declared here and assigned in both branches *)
      condition : expr;
      then_ : statement list;
      else_ : statement list;
      predicted : bool;  (** compiled to a branch rather than a select: see {!Feedback} *)
      span : Span.t;
    }
  | Step of {
      node : int;
      state : field option;  (** [None] if the node has no state *)
      arguments : expr list;
      results : variable list;  (** declared here *)
      on_trial : bool;
          (** whether the step runs on a copy of the state, which is discarded afterwards *)
      span : Span.t;
    }
  | Loop of loop
  | Reset of { node : int; state : field; arguments : expr list; span : Span.t }
      (** resets all states in the field *)
  | Enter of { entry : entry; span : Span.t }
  | Run of run
  | Return of { value : expr; span : Span.t }
      (** must be the last statement; occurs only if there is a single output *)

and loop = {
  node : int;
  state : field option;
  count : int;
  initial : expr list;  (** initial values of the accumulators *)
  arguments : argument list;  (** arguments of the node's step *)
  results : variable list;  (** declared here: first the accumulators, then the arrays *)
  span : Span.t;
}
(** Repeats the step of a node. *)

and argument =
  | Accumulated of int  (** the accumulator with this index *)
  | Each of expr  (** the element of an array in each iteration *)
  | Same of expr
  | Counted of expr
      (** an Int that starts with this value and increases by one in each iteration *)

and entry = {
  mode : int;  (** index into the node's [modes] *)
  parameters : expr list;  (** values for the mode's [parameters] *)
  arguments : expr list;  (** arguments for the [reset] of its node *)
}
(** Enters a mode: stores its parameters, then resets its state. *)

and run = {
  active : expr option;  (** if False, nothing runs, and the results are unspecified *)
  clock : clock option;  (** present if [active] is present and a mode reads dt *)
  steps : int;  (** maximum number of modes that run in one instant *)
  controls : (expr * entry) list;  (** the first one whose condition is true is taken *)
  late : bool;
      (** whether controls are checked after the step of the running mode instead of before it *)
  drops : bool;
      (** whether the results of modes are discarded after a late control or a delayed transition *)
  cases : case list;  (** one case for each mode *)
  results : variable list;  (** declared here *)
  span : Span.t;
}
(** One instant of the node's machine (see {!Flow.Ir.machine}). For a mode that has just been
    entered, dt is 0. *)

and clock = {
  since : field;
  running : field;  (** a Bool: False until the end of the machine's first instant *)
  elapsed : expr;  (** [since] plus the length of this instant *)
}
(** The time since a machine last ran; 0 until its first instant. *)

and case = {
  arguments : expr list;  (** arguments for the step of the mode's node *)
  others : variable list;
      (** results of the step that are not results of the machine, declared here *)
  transitions : next list;  (** the first one whose condition is true is taken *)
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
      (** only the parameters that the function reads; for the root's step, all leaves of the input
      *)
  body : statement list;
}

type node = {
  name : string;  (** unique in the program *)
  origin : string;  (** name of the definition in the source *)
  file : string;
  span : Span.t;
  state : field list;  (** {!State_struct} chooses the place of each field in memory *)
  modes : mode list;  (** the modes of its machine, if there is one *)
  foreign : Flow.Ir.foreign option;
      (** if present, step and reset are in the user's C code: [reset] and [step] have no body, and
          the state, if there is any, is one [Component] *)
  reset : code;  (** empty if there is no state, or the reset is never called *)
  step : code;
  outputs : (string * ty) list;
      (** first the node's outputs, then the values that only transitions read *)
  ends_early : int option;
      (** present for a mode whose step can end early. If one of its transitions occurs, the step
          returns only the outputs with this index or a higher one (see {!Early_end}) *)
  seconds : bool;  (** whether the step, or a callee, reads [Dt] *)
  nanoseconds : bool;  (** whether the step, or a callee, reads [Dt_nanoseconds] *)
  operations : int;  (** approximate number of operations in the step, without callees *)
}

type mark = {
  field : field;
  own : bool;
      (** whether the field is set at the start of the step. Otherwise, it is set at the end, like
          any delay *)
}
(** A Bool of the root that is False until the first step. *)

type program = {
  name : string;  (** base name of the C files *)
  real : Real.t;  (** the precision of [Float] *)
  sums : Flow.Ir.sum array;
  nodes : node array;  (** callees before callers; the last is the root *)
  imports : Flow.Ir.import list;
  headers : Flow.Ir.header list;  (** headers of the user's C code *)
  input : Flow.Ir.shape;
  console : Core.Ir.control list;  (** as in {!Flow.Ir.program} *)
  output : Flow.Ir.shape;
  ends : bool;  (** as in {!Flow.Ir.program} *)
  probes : (string * Flow.Ir.shape) list;  (** as in {!Flow.Ir.program} *)
  claims : Flow.Ir.claim list;  (** as in {!Flow.Ir.program} *)
  marks : int;  (** as in {!Flow.Ir.program} *)
  params : Flow.Ir.param list;
  started : mark option;
      (** present if the program can observe the dt of the first instant, which must therefore be
          replaced by 0 *)
}
