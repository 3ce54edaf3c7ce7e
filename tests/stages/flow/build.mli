(** Flow programs by hand, for tests.

    Lines number themselves: every signal stands on a line of its own, in the order of creation
    within its node, unless [line] says another. *)

open Flow

type t
(** A program being built. *)

type node
(** A node being built. *)

val create : unit -> t

val span : string -> int -> Basis.Span.t
(** A line of a file. *)

val node : ?kind:Ir.kind -> ?file:string -> t -> string -> (node -> (string * Ir.atom) list) -> int
(** Adds the node whose outputs the function gives; its index. *)

val static : ?ty:Ir.ty -> node -> string -> Ir.atom
val input : ?ty:Ir.ty -> node -> string -> Ir.atom

val declare : ?ty:Ir.ty -> ?line:int -> ?group_of:Ir.signal -> node -> string -> Ir.signal
(** For feedback: a signal that {!define} defines later. *)

val define : node -> Ir.signal -> Ir.rhs -> unit

val let_ : ?ty:Ir.ty -> ?line:int -> node -> string -> Ir.rhs -> Ir.atom
(** Both at once. *)

val param : Ir.ty -> Ir.rhs
(** That of {!params} of this type: Bool, Int or Float. *)

val op : ?ty:Ir.ty -> node -> Ir.operator -> Ir.atom list -> Ir.atom
(** An operation without a name. *)

val call :
  ?statics:Ir.atom list -> ?line:int -> node -> int -> Ir.atom list -> Ir.signal list -> unit
(** An instance, with its inputs and the declared signals that it defines. *)

val run : ?statics:Ir.atom list -> node -> int -> Ir.atom list -> string -> Ir.atom
(** An instance with one output, of that name and of type Float. *)

val params : Ir.param list
(** One of each type that a parameter may have. *)

val program : ?sums:Ir.sum array -> ?params:Ir.param list -> t -> Ir.program
(** The last node is the root. *)
