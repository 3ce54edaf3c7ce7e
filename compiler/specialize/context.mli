(** What one specialization of a program carries along. *)

open Basis

type options = {
  limit : int;  (** how often one definition may be specialized *)
  nesting : int;  (** how deeply nodes nest before one is {!Postponed} *)
  depth : int;  (** how deeply calls may nest that make no nodes *)
  work : int;  (** how many calls may be evaluated *)
  marks : int option;  (** for how many a drawing has room; without, it comes to nothing *)
}

val default : options

(** {1 The calls that led to a place} *)

type trail

val start : trail

val from_here : trail -> trail
(** The same calls, with nothing nested yet. *)

val since : trail -> trail -> (string * Span.t) list
(** The calls of the second after those of the first, with their places; the last one first. *)

(** {1 The context} *)

type definition = { core : Core.Ir.definition; code : int  (** a number that is no local's *) }

type specialization = {
  callee : callee;
  result : Value.t;  (** in terms of the node's own signals *)
  outputs : Flow.Ir.atom list;  (** the holes of the result *)
}

and callee =
  | Node of int
  | Nothing of Flow.Ir.signal list  (** a node without equations; its statics and inputs *)

(** What the program asks of its operator: it is found out, or was found out before. *)
type console =
  | Sought of { mutable found : Core.Ir.control list  (** the last one first *) }
  | Declared of Core.Ir.control list

type t = {
  sink : Diagnostic.sink;
  real : Real.t;
  foreign : Core.Ir.foreign;
  console : console;
  constants : Core.Constant_numbers.t;
  options : options;
  types : Types.table;
  free : Free.table;
  keys : Skeleton.table;
  fresh : unit -> int;
  instances : Core.Instance.table;
  definitions : definition Resolve.Global_table.t;
  params : Core.Ir.param list;
  names : Names.t;  (** of nodes *)
  globals : Value.t Variables.Table.t;  (** values of definitions without signals *)
  begun : unit Variables.Table.t;  (** definitions once postponed *)
  specializations : specialization Variables.Table.t;  (** by {!Skeleton.key} *)
  building : trail Variables.Table.t;  (** machines that are being made, likewise *)
  counts : int String_table.t;  (** specializations of a definition *)
  mutable nodes : Flow.Ir.node list;  (** the last one first *)
  mutable kept : Span.t list;  (** where {!check_lasting} found something *)
  mutable reported : (string * Span.t) list;  (** by {!report_once} *)
  mutable node_count : int;
  mutable entered : int;
  mutable draws : bool;  (** a mark was drawn somewhere *)
}

val create : Diagnostic.sink -> options -> ?seeks:bool -> Core.Ir.program -> t
(** [seeks]: what stands on the console is to be found out. *)

val known_by_name : Core.Ir.Global.t list
(** Definitions of the library that are looked for, whether or not the program mentions them: by one
    of them the file of the prelude is known. *)

val in_prelude : t -> Span.t -> bool
(** Not in the program's own modules, nor in the rest of the library. *)

val in_library : t -> Span.t -> bool

exception Stopped
(** An error was reported that leaves nothing to go on with. *)

exception Postponed of (unit -> unit)
(** The stack has become deep: what stands there is to be evaluated first, on a stack of its own;
    then its caller again, which will find it done. *)

val settle : (unit -> unit) -> unit
(** Evaluates, with all that is postponed. *)

val nests_deeply : t -> trail -> bool

val enter : t -> trail -> name:string -> span:Span.t -> trail
(** One call further in. Reports calls that nest too deeply, or are too many; then raises
    {!Stopped}. *)

val count : t -> trail -> name:string -> span:Span.t -> unit
(** One more specialization of the definition, which may be one too many. May raise {!Stopped}. *)

val report_outside : t -> trail -> span:Span.t -> index:int -> size:int -> unit
(** Of an array whose size depends on the call. *)

val own_place : t -> trail -> span:Span.t -> Span.t
(** The innermost call outside of the library that leads to a place; the place if there is none. *)

val report_once : t -> code:string -> at:Span.t -> Diagnostic.t -> unit
(** Of a place that may be evaluated many times. *)

val report_stored : t -> trail -> span:Span.t -> string -> unit
(** A [delay] of a value of this type, which has a function in it. The place is the call in the
    program's own folder that leads there. *)

val check_lasting : t -> trail -> span:Span.t -> Flow.Ir.ty list -> unit
(** E0430 if what is to be in the program's state lives for the instant only, and that was not said
    of one of the calls that led here. *)

val add_node : t -> Flow.Ir.node -> int
