(** Builds Flow programs by hand, for tests.

    Lines are numbered automatically: within a node, signals are on consecutive lines in the order
    of their creation, unless [line] is given. *)

open Flow

type t
(** A program under construction. *)

type node
(** A node under construction. *)

val create : unit -> t

val span : string -> int -> Basis.Span.t
(** A line of a file, as a span. *)

val node : ?kind:Ir.kind -> ?file:string -> t -> string -> (node -> (string * Ir.atom) list) -> int
(** Adds a node; the function builds it and returns its outputs. Returns its index. *)

val static : ?ty:Ir.ty -> node -> string -> Ir.atom
val input : ?ty:Ir.ty -> node -> string -> Ir.atom

val declare : ?ty:Ir.ty -> ?line:int -> ?group_of:Ir.signal -> node -> string -> Ir.signal
(** Declares a signal that {!define} defines later, for feedback. *)

val define : node -> Ir.signal -> Ir.rhs -> unit

val let_ : ?ty:Ir.ty -> ?line:int -> node -> string -> Ir.rhs -> Ir.atom
(** Declares and defines a signal. *)

val param : Ir.ty -> Ir.rhs
(** The parameter of {!params} with this type: Bool, Int or Float. *)

val op : ?ty:Ir.ty -> node -> Ir.operator -> Ir.atom list -> Ir.atom
(** A signal without a name for the result of an operation. *)

val call :
  ?statics:Ir.atom list -> ?line:int -> node -> int -> Ir.atom list -> Ir.signal list -> unit
(** Adds an instance, with its inputs and the declared signals that it defines. *)

val run : ?statics:Ir.atom list -> node -> int -> Ir.atom list -> string -> Ir.atom
(** Adds an instance with one output of type Float and this name. *)

val params : Ir.param list
(** One parameter of each type that parameters can have. *)

val program : ?sums:Ir.sum array -> ?params:Ir.param list -> t -> Ir.program
(** The finished program; the last node is its root. *)
