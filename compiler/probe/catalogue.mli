(** Names all inner signals of a program that can be shown.

    For each instance of a signal function, these are its parameters, the variables of its input and
    the signals that its equations define. For each switch or sequence of tasks, the running mode is
    a signal, too.

    Each signal has a path from the root. Instances are named after their definitions. Several
    instances of one definition in the same signal function are numbered in source order, and so are
    several modes of the same name. A mode that has the name of its machine adds nothing to the
    path. If a machine has only one mode, both have the name of the mode. The name of a signal is
    the shortest suffix of its path that is unique: [wallFollow.v], or [left.hold.y] if there is
    [right.hold.y] too. *)

open Basis

(** A step from a node to a node inside it. *)
type step =
  | Instance of int  (** index in the node's [instances] *)
  | Mode of int  (** index in the [modes] of the node's machine *)

type own = Signal of Flow.Ir.signal | Running_mode  (** the running mode of the node's machine *)

type probe = {
  name : string;
  path : step list;  (** path from the root to the node *)
  own : own;  (** the signal in this node *)
  whole : string list;  (** names on the path from the root to the instance *)
  signal : string;  (** name of the signal within its node *)
  ty : Flow.Ir.ty option;  (** type of the signal; [None] for [Running_mode] *)
  handed_down : bool;
      (** whether the signal is a copy of the program's own input, which is shown in any case *)
  span : Span.t;  (** its place in the source *)
}

val of_program : Equations.t -> Flow.Ir.program -> probe list option
(** Lists the probes in source order; inner instances follow the instance that contains them. [None]
    if there are more than {!most} instances. Skips arrays with more than 1,000 leaves and values of
    foreign types. *)

val most : int

val defined : Flow.Ir.node -> Flow.Ir.signal list
(** The signals that equations and instances define. *)

val modes_of : Flow.Ir.program -> probe -> string list
(** The names of the modes that a [Running_mode] can show. *)

val mode_names : Flow.Ir.program -> Flow.Ir.machine -> string list
(** Unique names for the modes of a machine. *)
