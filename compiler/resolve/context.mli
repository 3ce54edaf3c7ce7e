(** The state of one run of the resolver: the reported facts, the counter of local variables, and
    the nesting depth of the current expression. *)

open Basis

type t

val create : Fact.t Facts.t -> t

(** {1 Facts} *)

val report : t -> Fact.t -> unit
val report_definition : t -> Fact.in_definitions -> unit
val report_type : t -> Fact.in_types -> unit
val report_record : t -> Fact.in_records -> unit
val report_foreign : t -> Fact.in_foreign_code -> unit
val warn : t -> Fact.warning -> unit

val report_unresolved : t -> Fact.unresolved -> unit
(** Holds the fact back until {!tell} is called. *)

val tell : t -> Visible.t -> unit
(** Reports the undefined names of a module. Must be called at the end of the module. *)

val has_errors : t -> bool
(** Has this run reported an error? *)

val parse : t -> file:string -> string -> Syntax.Ir.program option
(** Calls {!Syntax.Parse.program} and reports its errors. *)

(** {1 Expressions} *)

val fresh : t -> string -> Span.t -> Ir.Local.t
(** Creates a local variable with a new id. *)

val deepest : int
(** The maximum number of nesting levels: 10,000. *)

val nested : t -> Span.t -> otherwise:'a -> (unit -> 'a) -> 'a
(** Runs a function one nesting level deeper. If that would exceed {!deepest}, reports an error
    (only once) and returns [otherwise], because the stack could overflow. *)

val import_place : Syntax.Ir.program -> Ir.import_place
