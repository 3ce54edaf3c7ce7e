(** All inner signals of a program that can be seen, by name.

    Those are, in each instance of a signal function, its parameters, the signals of its input and
    of its equations, and of each switch or sequence of tasks which of its modes runs.

    An instance is called as its definition; several in one signal function, or several modes of one
    name, are numbered in the order of the text. A mode that is called as what it is a mode of has
    no name of its own in the way, and the only one has the name for both. A name is the shortest
    end of the way that leads from the root to the signal that no other has: [wallFollow.v], or
    [left.hold.y] where there is [right.hold.y] too. *)

open Basis

(** From a node to one inside. *)
type step =
  | Instance of int  (** the number in the node's [instances] *)
  | Mode of int  (** in the [modes] of its machine *)

type own = Signal of Flow.Ir.signal | Running_mode  (** which of the node's machine *)

type probe = {
  name : string;
  path : step list;  (** from the root to the node *)
  own : own;  (** of that node *)
  whole : string list;  (** what leads from the root, by name *)
  signal : string;  (** how it is called in its node *)
  ty : Flow.Ir.ty option;  (** of the signal; [None] for [Running_mode] *)
  handed_down : bool;  (** it is the program's own input, which is seen anyway *)
  span : Span.t;  (** where the programmer wrote it *)
}

val of_program : Equations.t -> Flow.Ir.program -> probe list option
(** In the order of the text, inner instances after what is around them. [None] if there are more
    than {!most} instances. Arrays of more than {!longest} leaves and values of foreign types are
    left out. *)

val most : int
val longest : int

val defined : Flow.Ir.node -> Flow.Ir.signal list
(** By equations and instances. *)

val modes_of : Flow.Ir.program -> probe -> string list
(** Of a [Running_mode]: what it can be. *)

val mode_names : Flow.Ir.program -> Flow.Ir.machine -> string list
(** Of its modes, each another. *)
