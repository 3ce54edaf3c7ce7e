(** Allocates the fields that a node's equations and instances need. *)

type t

val of_node :
  callee:(int -> Ir.node) -> statics:(int -> (Ir.variable * Ir.origin) list) -> Statics.t -> t
(** [callee] returns a preceding node, [statics] its static parameters. *)

val origin : Flow.Ir.signal -> Ir.origin

type memory =
  | Delayed of Ir.field
  | Elapsed of { time : Ir.field; restart : Flow.Ir.atom }
  | Ticked of { time : Ir.field; period : Flow.Ir.atom }  (** time since the last tick *)
  | Integrated of { value : Ir.field; input : Ir.expr }
      (** [input]: the previous input, which is a field or a constant *)
  | Differentiated of { value : Ir.field; input : Ir.field }
  | Kept of Ir.field  (** an expensive static value, computed by the reset *)

val past_first : string
(** The purpose of the Bool that is False until the end of the first instant. *)

val memory : t -> Flow.Ir.signal -> memory option
val instance : t -> Flow.Ir.instance -> Ir.field option

type machine = { clock : Ir.clock option; modes : Ir.mode list }
(** The state of a machine. *)

val machine : t -> machine option

val modes : t -> Ir.mode list
(** The modes of the machine; empty if the node has no machine. *)

val fields_of_mode : Ir.mode -> Ir.field list
(** The fields for the parameters and the state of the mode. *)

val fields : t -> Ir.field list
(** All fields: first the fields of the step's items, in order, then the fields of [Kept] values. *)
