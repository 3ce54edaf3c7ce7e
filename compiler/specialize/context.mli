(** The state of one specialization of a program. *)

open Basis

type options = {
  limit : int;  (** maximum number of specializations of one definition *)
  nesting : int;  (** nesting depth beyond which a node is {!Postponed} *)
  depth : int;  (** maximum nesting depth of calls that create no nodes *)
  work : int;
      (** base limit on {!Work} steps; {!allowed_work} raises it with the length of the program *)
  marks : int option;  (** maximum number of marks in a drawing; [None] disables drawing *)
}

val default : options

(** {1 Call stacks} *)

type trail

val start : trail

val from_here : trail -> trail
(** The same calls, with the nesting depth reset to 0. *)

val calls : trail -> Calls.t

val since : trail -> trail -> Calls.t
(** The calls in the second trail that are not in the first, each with its place, innermost first.
*)

(** {1 The context} *)

type definition = {
  core : Core.Ir.definition;
  code : int;  (** a number that differs from the ids of all locals *)
}

type specialization = {
  callee : callee;
  result : Value.t;  (** the value in terms of the node's own signals *)
  outputs : Flow.Ir.atom list;  (** the atoms that fill the holes of the result *)
}

and callee =
  | Node of int
  | Nothing of Flow.Ir.signal list  (** a node without equations; its statics and inputs *)

type wide = { ty : Core.Ir.ty; leaves : int; mutable uses : int }
(** A type with many leaves, and the number of equations and calls that define a value of that type.
*)

(** The controls that the program requests from its operator, collected either by this
    specialization or by an earlier one. *)
type console =
  | Sought of { mutable found : Core.Ir.control list  (** newest first *) }
  | Declared of Core.Ir.control list

type t = {
  facts : Fact.t Facts.t;
  mutable failed : bool;  (** whether a fact has been reported *)
  real : Real.t;
  foreign : Core.Ir.foreign;
  console : console;
  constants : Core.Constant_numbers.t;
  options : options;
  types : Types.table;
  free : Free.table;
  keys : Specialization_key.table;
  fresh : unit -> int;
  instances : Core.Instance.table;
  definitions : definition Resolve.Global_table.t;
  params : Core.Ir.param list;
  param_numbers : int Resolve.Global_table.t;  (** the position of each parameter in [params] *)
  names : Names.t;  (** names of nodes *)
  globals : Value.t Variables.Table.t;  (** values of definitions that contain no signals *)
  begun : unit Variables.Table.t;  (** definitions that have been postponed once *)
  specializations : specialization Variables.Table.t;
      (** specializations by {!Specialization_key.key} *)
  building : trail Variables.Table.t;
      (** machines under construction, by {!Specialization_key.key} *)
  counts : int String_table.t;  (** number of specializations of each definition *)
  mutable nodes : Flow.Ir.node list;  (** newest first *)
  mutable kept : Span.t list;  (** places reported by {!check_lasting} *)
  mutable controls : Control_fact.t list;  (** reported by {!report_control} *)
  mutable node_count : int;
  called : int ref String_table.t;  (** how often each name was called *)
  wide : wide Int_table.t;  (** by layout; see {!defining} *)
  mutable latest : trail;
  size : int;  (** number of expressions in the program *)
  mutable draws : bool;  (** whether the program has drawn a mark *)
}

val create : Fact.t Facts.t -> options -> ?seeks:bool -> Core.Ir.program -> t
(** [seeks]: whether to collect the controls that the program requests. *)

val known_by_name : Core.Ir.Global.t list
(** Library definitions that the specializer looks up, whether or not the program mentions them. One
    of them identifies the file of the prelude. *)

val in_prelude : t -> Span.t -> bool
(** Is the place in the prelude, rather than in the rest of the library or the program's own
    modules? *)

val in_library : t -> Span.t -> bool

exception Stopped
(** Raised after reporting an error that prevents further specialization. *)

exception Postponed of (unit -> unit)
(** Raised if the stack has become too deep. Its argument evaluates the part that was too deep and
    must be called on a fresh stack. The evaluation that raised the exception is then repeated and
    finds the result. *)

val settle : (unit -> unit) -> unit
(** Calls the function, then every function that was postponed during the call. *)

val nests_deeply : t -> trail -> bool

(** {1 Causes of excessive work}

    These functions collect data for {!Used_up}, which reports the cause when the step limit is
    reached. *)

type expansion = {
  by : string;  (** the function that expands the elements one by one *)
  elements : int;
  at : Span.t;
}

type machine = { of_ : string; place : Span.t; mutable modes : int }

val expanding : t -> trail -> by:string -> elements:int -> span:Span.t -> trail
(** Enters an array whose elements are being expanded. May raise {!Work.Used_up}. *)

val defining : t -> trail -> Core.Ir.ty -> unit
(** Records that an equation or a call defines a value of this type, for {!widest}. *)

val widest : t -> wide option
(** The type whose values account for the most leaves, over all equations and calls. *)

val in_machine : trail -> machine -> trail
(** Enters a machine whose modes are being discovered. *)

val expansions : trail -> expansion list
(** The expansions that contain this place, the innermost one first. *)

val machines : trail -> machine list
(** The machines that contain this place, the innermost one first. *)

val latest : t -> trail
(** The last call that was entered. *)

val most_called : t -> (string * int) option
(** The name that was called most often, and how often. *)

val most_specialized : t -> (string * int) option
(** The name that was specialized most often, and how often. *)

val allowed_work : t -> int

val enter : t -> trail -> name:string -> span:Span.t -> trail
(** Enters a call. If calls are nested too deeply, reports that and raises {!Stopped}. *)

val count : t -> trail -> name:string -> span:Span.t -> unit
(** Counts one more specialization of the definition, or one more mode of the surrounding machine.
    Raises {!Stopped} if that exceeds the limit. *)

val own_place : t -> trail -> span:Span.t -> Span.t
(** The innermost place outside the library among [span] and the calls that lead to it; [span] if
    there is none. *)

val report : t -> Fact.t -> unit

val stop : t -> Fact.t -> 'a
(** Reports the fact and raises {!Stopped}. *)

val report_control : t -> Control_fact.t -> unit
(** Reports the fact unless it has already been reported: the same place may be evaluated many
    times. *)

val report_stored : t -> trail -> span:Span.t -> Core.Ir.ty -> unit
(** Reports a [delay] of a value of this type, which contains a function. *)

val check_lasting : t -> trail -> span:Span.t -> Flow.Ir.ty list -> unit
(** Reports a value that would be stored in the program's state although it is valid for only one
    instant. Does nothing if such a value was already reported for one of the calls that led here.
*)

val add_node : t -> Flow.Ir.node -> int
