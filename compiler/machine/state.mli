(** The fields that a node's equations and instances need. *)

type t

val of_node : stateful:(int -> bool) -> Statics.t -> t
(** [stateful] tells of the nodes before this one whether they have state. *)

type memory =
  | Delayed of Ir.field
  | Elapsed of Ir.field  (** local time *)
  | Integrated of { value : Ir.field; input : Ir.field }
  | Differentiated of { value : Ir.field; input : Ir.field }
  | Kept of Ir.field  (** a costly static value, computed by reset *)

val memory : t -> Flow.Ir.signal -> memory option
val instance : t -> Flow.Ir.instance -> Ir.field option

val fields : t -> Ir.field list
(** All, in the order of the step's items, then what is kept. *)

val new_field : t -> name:string -> Ir.content -> purpose:string -> Basis.Span.t -> Ir.field
