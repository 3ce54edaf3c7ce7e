(** Flow: the program as first-order nodes of equations over signals.

    No longer there: types other than Bool, Int, Float, sums and arrays of these; functions, tuples,
    records and signal functions as values. A tuple or record is the list of its leaves, in order; a
    sum value is one leaf; an array of tuples or records is one array for each leaf of its elements.

    Always true (see {!Lint}): a signal has exactly one equation, in the node that owns it; a node's
    callees come before it in [program.nodes]; all operations are total, so an equation may be
    computed although nothing needs it, or not at all although something might have; state lives
    only in [Delay], [Instance], [Integrate]-like equations and machines; a mode belongs to one
    machine. Order of equations has no meaning; they may be mutually recursive ({!Causality}
    checks). *)

open Basis

type ty =
  | Bool
  | Int
  | Float
  | Sum of int  (** index into [program.sums] *)
  | Array of int * ty  (** size, at least 1, and element *)
  | Foreign of foreign_type

and foreign_type = {
  foreign_name : string;  (** in the program *)
  c_type : string;
  copyable : bool;
      (** if not, there is only the address of a value, good for the instant: it is never in a state
      *)
}
(** A type of the user's C. *)

type sum = {
  name : string;  (** as the programmer would write the type: [Maybe Float] *)
  module_ : string;  (** where its data type is declared *)
  constructors : sum_constructor list;
}
(** Data types with more than one constructor, at closed types. *)

and sum_constructor = {
  constructor : string;
  fields : (string * shape) list;  (** the name is [""] if positional *)
}

(** How a value of the source language is made of leaves. *)
and shape =
  | Leaf of ty  (** no array *)
  | Product of product
  | Repeated of int * shape  (** an array *)

and product = {
  product_name : string;  (** [""] for a tuple, else the record's type *)
  product_module : string;
  constructor : string;  (** [""] for a tuple *)
  record : bool;  (** the constructor's fields have names *)
  parts : (string * shape) list;  (** field names; [""] for components and positional fields *)
}

type signal = {
  id : int;  (** unique in the program *)
  name : string;
      (** the programmer's name, with a path for leaves ([v], [pose.x]); [""] for what has none *)
  ty : ty;
  group : int;  (** equal for the leaves that causality judges as one; usually [id] *)
  span : Span.t;  (** where the programmer wrote it; never a dummy *)
}

type atom = Signal of signal | Bool of bool | Int of int32 | Float of float

type operator =
  (* on Int or Float, by the type of the arguments; [Equal] on Bool too *)
  | Add
  | Subtract
  | Multiply
  | Negate
  | Absolute
  | Signum
  | Equal
  | Less
  | Less_equal
  | Minimum  (** NaN if either is; else the first of two equal ones *)
  | Maximum
  (* Float *)
  | Divide
  | Pow  (** the runtime's [pow] *)
  | Elementary of Core.Primitive.elementary
  (* Int *)
  | Div
  | Mod
  | Bitwise of Core.Primitive.bitwise
  (* conversions, saturating *)
  | To_float
  | Round
  | Floor
  | Ceiling
  | Truncate
  (* Bool *)
  | Not
  | And
  | Or

type equation = { defines : signal; rhs : rhs; span : Span.t }

and rhs =
  | Copy of atom
  | Op of operator * atom list
  | If of { condition : atom; then_ : atom; else_ : atom }
      (** Any of the branches may be left uncomputed where not needed. *)
  | Construct of { constructor : int; payload : atom list }
      (** payload: all leaves of all fields, in order *)
  | Is_constructor of atom * int
  | Payload of { value : atom; constructor : int; leaf : int }
      (** unspecified, but harmless, if [value] has another constructor *)
  | Delay of { init : atom; next : atom }
      (** [init] at the first instant, then [next] as it was one instant ago; [init] is static *)
  | Elements of atom list  (** an array written out *)
  | Fill of atom  (** an array of equal elements *)
  | Index of atom * int  (** inside the array *)
  | At of { array : atom; index : atom; default : atom }  (** [default] outside the array *)
  | Replace of { array : atom; index : atom; value : atom }
      (** the same array with one other element; unchanged if outside *)
  | Param of int  (** of [program.params]: always the same in a run *)
  | Absent  (** a foreign value that is not there, which nothing looks at *)
  | Time of { restart : atom }
      (** local time, and 0 where [restart] holds and from then on the time since: seconds, a Float.
          What is kept is nanoseconds, so a program that asks for these ([Elementary Nanoseconds])
          gets them without a way back *)
  | Step_time  (** seconds since the instant before, and 0 at the first *)
  | Ticks of atom
      (** of a static number of nanoseconds, a whole one (a fraction is dropped): does it or a
          multiple of it lie between this local time and the one an instant ago, which does not
          count? Always if less than 1, never if NaN *)
  | Integral of atom  (** 0, then adds dt times the argument as it was one instant ago *)
  | Derivative of atom

type instance = {
  node : int;  (** index into [program.nodes] *)
  name : string;  (** of the state field; unique in the node *)
  statics : atom list;  (** for the node's [statics] *)
  inputs : atom list;  (** for the node's [inputs] *)
  outputs : signal list;
      (** defined here; for the node's [outputs]. Of a loop: first the accumulators as they are at
          the end, then arrays of the others *)
  loop : loop option;
  trials : trial list;
      (** for outputs that are known before all inputs, on which they do not depend; none of a loop
      *)
  span : Span.t;
}
(** A private copy of a node's state, or a call if the node has none; with a loop, as many of them
    as the loop counts, one after the other. *)

and loop = {
  count : int;  (** at least 1 *)
  arguments : argument list;  (** how each of [inputs] is passed *)
}

and argument =
  | Accumulator
      (** the first time as given, then the node's output of the same number; accumulators come
          first *)
  | Element  (** each time the next of the array given *)
  | Same  (** each time as given *)
  | Counter  (** an Int: as given, then one more each time *)

and trial = {
  gives : signal list;  (** some of the instance's outputs, in order *)
  given : atom option list;  (** for its inputs; [None]: any value would do *)
}
(** A step of the instance that gives some of its outputs, and leaves its state as it is. Not every
    part of a program can be taken apart so that outputs come first: modes of a machine, for one. *)

type kind =
  | Function  (** no state: equations are operations, instances functions *)
  | Signal_function

type import = {
  symbol : string;  (** its name in C, or what its names begin with *)
  kind : kind;
  arguments : shape list;  (** one for a signal function *)
  result : shape;
}
(** What is imported from the user's C, whether the program runs it or not. *)

type foreign = {
  import : import;  (** [inputs] are the leaves of its arguments *)
  results : signal list;  (** defined here: the leaves of its result *)
}
(** A node that is C code of the user's: it has no equations, instances or machine, and each result
    needs all inputs. *)

type transition = {
  occurs : atom;
  target : int;  (** index into the machine's [modes] *)
  arguments : atom list;  (** for the statics of the target's node *)
  delayed : bool;  (** at this instant the output is still that of the mode that is left *)
  at_entry : at_entry;
  by : follower;
  span : Span.t;
}
(** From a running mode of a machine to the next. *)

(** The definition that says what comes next, for messages. *)
and follower =
  | Continuation of string  (** of a switch *)
  | Statement of string  (** after a task that ends *)

(** Whether a mode's transition may occur at the mode's own first instant, which
    {!Instantaneous_loops} finds out. *)
and at_entry =
  | Possible
  | Impossible of (string * Span.t) option
      (** the signal function that has no event there, as far as it is known, and where it runs *)

type machine = {
  modes : int list;
      (** nodes before this one, with [inputs] and [outputs] as the machine, and with [transitions];
          a mode's statics are its parameters *)
  start : transition list;  (** static, of the node's own signals; the last one is unconditional *)
  active : atom option;
      (** if given, the machine has its instants where it holds, dt being the time since its own
          last one, and unspecified outputs elsewhere *)
  controls : transition list;  (** of the node's own signals *)
  inputs : atom list;
  outputs : signal list;  (** defined here *)
  steps : int;  (** at most so many modes are stepped in one instant *)
  span : Span.t;
}
(** One of several signal functions at a time: a node's state is that of the mode that runs, and
    nothing is left over of the one before.

    One instant: of the first of [controls] that occurs, if not delayed, the target is entered; then
    the running mode is stepped. While one of its own transitions occurs (the first counts) its
    target is entered and stepped; a delayed control comes after that. A mode is entered with its
    parameters assigned all at once, its local time 0; what it outputs after a delayed transition is
    dropped, its events count. *)

type node = {
  name : string;  (** from the source; unique in the program *)
  origin : string;  (** the definition as the programmer knows it *)
  kind : kind;
  statics : signal list;  (** known when the node starts, and fixed *)
  inputs : signal list;
  outputs : (string * atom) list;  (** name and value of each leaf *)
  equations : equation list;
  instances : instance list;
  foreign : foreign option;
  machine : machine option;
      (** if there is one, it is all the state there is: the equations are operations, the instances
          functions *)
  transitions : transition list;
      (** of a mode of a machine, the first that occurs counts; else none *)
  span : Span.t;
  file : string;
}

type param = {
  label : string;  (** what it is called outside of the program: its name, or [M.name] *)
  param_ty : ty;  (** [Bool], [Int] or [Float] *)
  unit_ : string;  (** as it is written in brackets; [""] of a [Bool] *)
  default : atom;  (** which nothing but a run may rest on *)
  doc : string option;
  declared : Span.t;
}
(** What is fixed when a run starts. *)

type claim = {
  column : string;  (** among the [probes] *)
  is_assumption : bool;
  label : string;
  shown : bool;  (** as a column of traces, like other probes *)
  claimed_at : Span.t;
  margin : string option;  (** how nearly it holds, by other [probes]: see {!Core.Formula} *)
}
(** An assertion of the program that is watched. *)

type header = { header : string; folder : string  (** its path is from there *) }

type program = {
  name : string;  (** of the C files *)
  real : Real.t;  (** the precision of [Float]; each [atom] of that type has it *)
  sums : sum array;
  nodes : node array;  (** callees before callers; the last is the root *)
  next_id : int;
      (** larger than every signal's id and group; ids are given one after the other, so a table by
          id may be an array of this size *)
  imports : import list;  (** each of the user's C once, by symbol *)
  headers : header list;  (** of the user's C *)
  input : shape;  (** of the root's inputs *)
  console : Core.Ir.control list;
      (** what stands on the operator's console: the parts of a record somewhere in [input] *)
  output : shape;
  ends : bool;
      (** the last part of the output is an event, at and after the end of the program: what it has
          ended with *)
  probes : (string * shape) list;
      (** inner signals to be seen, by what they are called: the root gives their leaves after those
          of [output] *)
  claims : claim list;  (** those of [probes] that are verdicts on assertions *)
  marks : int;  (** so many can be drawn in an instant, whether or not they are to be seen *)
  params : param list;
}
