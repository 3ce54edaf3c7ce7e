(** The declarations that describe a program's ROS 2 topics: records, and instances of classes of
    the module Ros. *)

open Basis

type t = {
  sink : Diagnostic.sink;
  resolved : Resolve.Ir.program;
  typed : Typing.Ir.program;
  types : Probe.Signal_types.t;
  entry : Typing.Ir.definition;
}

val in_ros : string -> Typing.Ir.Global.t
val in_prelude : string -> Typing.Ir.Global.t

val instance : t -> string -> Typing.Ir.Global.t -> Typing.Ir.instance option
(** The type's instance of this class of the module Ros. *)

val method_ : t -> Typing.Ir.instance -> (Typing.Ir.pattern * Typing.Ir.expr) option
(** The parameter and the body of the instance's only method. *)

val data : t -> Typing.Ir.Global.t -> Typing.Ir.data option

val fields : t -> Typing.Ir.Global.t -> string list option
(** The fields of a record; [None] if the type is not a record. *)

val place : t -> Typing.Ir.Global.t -> string -> Span.t
(** The place of a field's type in the record's declaration. *)

val name_place : t -> Typing.Ir.Global.t -> string -> Span.t
(** The place of a field's name in the record's declaration. *)

val refuse : t -> ?code:string -> at:Span.t -> string -> string -> unit
(** Reports an error with a hint. The default code is [E0509]. *)
