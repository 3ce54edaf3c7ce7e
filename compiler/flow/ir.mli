(** Flow: the program as first-order nodes of equations over signals.

    The only types are Bool, Int, Float, foreign types, and sums and arrays of these. Functions,
    signal functions, tuples and records are not values. A tuple or record is represented by the
    list of its leaves, in order. A sum value is one leaf. An array of tuples or records is
    represented by one array for each leaf of its elements.

    Invariants (see {!Lint}): a signal has exactly one equation, in the node that owns it; callees
    precede their callers in [program.nodes]; all operations are total, so an equation whose value
    is not needed may be computed or skipped; only instances, machines, and equations such as
    [Delay] and [Integral] have state; a mode belongs to one machine. The order of equations has no
    meaning; they may be mutually recursive ({!Causality} checks them). *)

open Basis

type ty =
  | Bool
  | Int
  | Float
  | Sum of int  (** index into [program.sums] *)
  | Array of int * ty  (** size (at least 1) and element type *)
  | Foreign of foreign_type

and foreign_type = {
  foreign_name : string;  (** name in the program *)
  c_type : string;
  copyable : bool;
      (** if false, a value exists only as an address that is valid for one instant, so it is never
          stored in the state *)
}
(** A type of the user's C code. *)

type sum = {
  name : string;  (** the type as a programmer would write it: [Maybe Float] *)
  module_ : string;  (** module that declares the data type *)
  constructors : sum_constructor list;
}
(** A data type with more than one constructor, applied to closed types. *)

and sum_constructor = {
  constructor : string;
  fields : (string * shape) list;  (** the name of a positional field is [""] *)
}

(** The structure of a source-language value in terms of its leaves. *)
and shape =
  | Leaf of ty  (** not an array *)
  | Product of product
  | Repeated of int * shape  (** an array *)

and product = {
  product_name : string;  (** the name of the type; [""] for a tuple *)
  product_module : string;
  constructor : string;  (** [""] for a tuple *)
  record : bool;  (** whether the constructor's fields have names *)
  parts : (string * shape) list;  (** field names; [""] for components and positional fields *)
}

type signal = {
  id : int;  (** unique in the program *)
  name : string;
      (** the programmer's name, with a path for leaves ([v], [pose.x]); [""] if it has none *)
  ty : ty;
  group : int;
      (** equal for leaves that the causality check treats as one; usually equal to [id] *)
  span : Span.t;  (** its place in the source; never a dummy *)
}

type atom = Signal of signal | Bool of bool | Int of int32 | Float of float

type operator =
  (* on Int or Float, depending on the arguments; [Equal] also on Bool *)
  | Add
  | Subtract
  | Multiply
  | Negate
  | Absolute
  | Signum
  | Equal
  | Less
  | Less_equal
  | Minimum  (** NaN if either argument is NaN; the first argument if both are equal *)
  | Maximum
  (* on Float *)
  | Divide
  | Pow  (** the runtime's [pow] *)
  | Elementary of Core.Primitive.elementary
  (* on Int *)
  | Div
  | Mod
  | Bitwise of Core.Primitive.bitwise
  (* saturating conversions *)
  | To_float
  | Round
  | Floor
  | Ceiling
  | Truncate
  (* on Bool *)
  | Not
  | And
  | Or

type equation = { defines : signal; rhs : rhs; span : Span.t }

and rhs =
  | Copy of atom
  | Op of operator * atom list
  | If of { condition : atom; then_ : atom; else_ : atom }
      (** A branch that is not needed may be skipped. *)
  | Construct of { constructor : int; payload : atom list }
      (** payload: all leaves of all fields, in order *)
  | Is_constructor of atom * int
  | Payload of { value : atom; constructor : int; leaf : int }
      (** the result is unspecified, but harmless, if [value] has a different constructor *)
  | Delay of { init : atom; next : atom }
      (** [init] in the first instant, afterwards the previous value of [next]; [init] is static *)
  | Elements of atom list  (** an array with these elements *)
  | Fill of atom  (** an array whose elements all have this value *)
  | Index of atom * int  (** the index is within bounds *)
  | At of { array : atom; index : atom; default : atom }
      (** [default] if the index is out of bounds *)
  | Replace of { array : atom; index : atom; value : atom }
      (** the array with one element replaced; unchanged if the index is out of bounds *)
  | Param of int  (** index into [program.params]; the parameter is constant during a run *)
  | Absent  (** a placeholder for a missing foreign value; it is never read *)
  | Time of { restart : atom }
      (** local time in seconds, a Float. Starts again at 0 whenever [restart] is true. The state
          contains nanoseconds, so a program that needs nanoseconds ([Elementary Nanoseconds]) gets
          them without a conversion *)
  | Step_time  (** seconds since the previous instant; 0 in the first instant *)
  | Ticks of atom
      (** true if a multiple of this static number of nanoseconds lies after the previous instant's
          local time and at or before the current local time. The number is truncated to an integer.
          Always true if the number is below 1, and never true if it is NaN *)
  | Integral of atom
      (** 0 in the first instant; each later instant adds dt times the previous value of the
          argument *)
  | Derivative of atom

type instance = {
  node : int;  (** index into [program.nodes] *)
  name : string;  (** name of the state field; unique in the node *)
  statics : atom list;  (** arguments for the node's [statics] *)
  inputs : atom list;  (** arguments for the node's [inputs] *)
  outputs : signal list;
      (** signals defined here, one for each of the node's [outputs]. For a loop: first the final
          values of the accumulators, then arrays of the other outputs *)
  loop : loop option;
  trials : trial list;
      (** trial steps for outputs that do not depend on all inputs; a loop has none *)
  span : Span.t;
}
(** An instance of a node with its own state, or a call if the node has no state. A loop has one
    instance for each iteration, and runs them one after another. *)

and loop = {
  count : int;  (** at least 1 *)
  arguments : argument list;  (** how the loop passes each of [inputs] *)
}

and argument =
  | Accumulator
      (** the given value in the first iteration, then the previous iteration's output with the same
          index; accumulators come first *)
  | Element  (** the next element of the given array in each iteration *)
  | Same  (** the same value in each iteration *)
  | Counter  (** an Int that increases by one in each iteration, starting with the given value *)

and trial = {
  gives : signal list;  (** some of the instance's outputs, in order *)
  given : atom option list;  (** the value of each input; [None] if the input does not matter *)
}
(** A trial step: computes some outputs of the instance and leaves its state unchanged. It is needed
    if some outputs must be known before all inputs are, and the node cannot be split, for example
    because it has a machine. *)

type kind =
  | Function  (** stateless: equations are operations, instances are functions *)
  | Signal_function

type import = {
  symbol : string;  (** its name in C; for a signal function, the prefix of its names in C *)
  kind : kind;
  arguments : shape list;  (** a signal function has exactly one *)
  result : shape;
}
(** A declaration that imports C code. The user's own imports are listed even if the program does
    not use them. *)

type foreign = {
  import : import;  (** the node's [inputs] are the leaves of its arguments *)
  results : signal list;  (** signals defined here: the leaves of its result *)
}
(** A node implemented by the user's C code. It has no equations, instances or machine, and each
    result needs all inputs. *)

type transition = {
  occurs : atom;
  target : int;  (** index into the machine's [modes] *)
  arguments : atom list;  (** arguments for the statics of the target's node *)
  delayed : bool;  (** if true, the output in this instant still comes from the previous mode *)
  at_entry : at_entry;
  by : follower;
  span : Span.t;
}
(** A transition from a running mode of a machine to the next mode. *)

(** The definition that determines the next mode, for messages. *)
and follower =
  | Continuation of string  (** continuation of a switch *)
  | Statement of string  (** statement after a task *)

(** Whether a mode's transition may occur in the first instant of that mode, as determined by
    {!Instantaneous_loops}. *)
and at_entry =
  | Possible
  | Impossible of (string * Span.t) option
      (** the signal function that prevents the transition, and its place, if known *)

type machine = {
  modes : int list;
      (** indices of nodes that come before this one. They have the same [inputs] and [outputs] as
          the machine, and may have [transitions]. The statics of a mode are its parameters *)
  start : transition list;
      (** these read static signals of this node; the last transition is unconditional *)
  active : atom option;
      (** if present, the machine runs only in instants in which this is true, and dt is the time
          since the machine last ran. In other instants its outputs are unspecified *)
  controls : transition list;  (** these read signals of this node *)
  inputs : atom list;
  outputs : signal list;  (** signals defined here *)
  steps : int;  (** maximum number of modes that run in one instant *)
  span : Span.t;
}
(** Runs one of several signal functions at a time. The machine's state is the state of the running
    mode; the state of previous modes is lost.

    In each instant, the machine first takes the first of [controls] that occurs, unless that one is
    delayed. Then the running mode takes a step. If one of the running mode's own transitions
    occurs, the machine enters the target of the first such transition, and that mode takes a step;
    this repeats until none occurs. A delayed control is taken after that. When the machine enters a
    mode, it assigns all parameters of the mode simultaneously, and the mode's local time starts at
    0. After a delayed transition, the outputs of the new mode are dropped, but its events take
    effect. *)

type node = {
  name : string;  (** from the source; unique in the program *)
  origin : string;  (** name of the definition in the source *)
  kind : kind;
  statics : signal list;  (** known when the node starts, and constant from then on *)
  inputs : signal list;
  outputs : (string * atom) list;  (** the name and value of each leaf of the output *)
  equations : equation list;
  instances : instance list;
  foreign : foreign option;
  machine : machine option;
      (** if present, the node has no other state: its equations are operations and its instances
          functions *)
  transitions : transition list;
      (** the transitions of a mode, of which the first one that occurs is taken; empty if the node
          is not a mode *)
  span : Span.t;
  file : string;
}

type param = {
  label : string;  (** its name for users: the plain name, or [M.name] *)
  param_ty : ty;  (** [Bool], [Int] or [Float] *)
  unit_ : string;  (** the unit as written in brackets; [""] for a [Bool] *)
  default : atom;
      (** the default value. It may be overridden, so it must not be treated as a constant *)
  doc : string option;
  declared : Span.t;
}
(** A parameter whose value is fixed when a run starts. *)

type claim = {
  column : string;  (** the name of the probe that contains the verdict *)
  is_assumption : bool;
  label : string;
  shown : bool;  (** whether traces contain this column, as they do for other probes *)
  claimed_at : Span.t;
  margin : string option;
      (** the margin by which the assertion is satisfied, as a formula over other [probes]; see
          {!Core.Formula} *)
}
(** A checked assertion of the program. *)

type header = { header : string; folder : string  (** folder to which its path is relative *) }

type program = {
  name : string;  (** base name of the C files *)
  real : Real.t;  (** the precision of [Float]; each Float atom is rounded to it *)
  sums : sum array;
  nodes : node array;  (** callees before callers; the last is the root *)
  next_id : int;
      (** larger than every signal's id and group. Ids are consecutive, so a table indexed by id can
          be an array of this size *)
  imports : import list;
      (** all the user's imports of C code, and the library's imports that some node calls. Each
          symbol occurs once *)
  headers : header list;  (** headers of the user's C code *)
  input : shape;  (** the root's inputs *)
  console : Core.Ir.control list;
      (** the controls on the operator's console, which is a record somewhere in [input] *)
  output : shape;
  ends : bool;
      (** if true, the last part of the output is an event that carries the program's result and
          occurs when the program ends and in all later instants *)
  rate : float option;
      (** the steps per second of a ROS 2 node with topics of its own; [None] for other programs *)
  probes : (string * shape) list;
      (** internal signals to show, with their names. The root returns their leaves after those of
          [output] *)
  claims : claim list;  (** the assertions whose verdicts are among the [probes] *)
  marks : int;
      (** maximum number of marks drawn in an instant, including marks that are not shown *)
  params : param list;
}
