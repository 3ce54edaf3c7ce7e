(** The fields that a node's equations and instances need, and what each
    equation reads and writes of them. *)

type t

val of_node : stateful:(int -> bool) -> Flow.Ir.node -> Flow.Schedule.item list -> t
(** [stateful] tells of the nodes before this one whether they have state. *)

type memory =
  | Delayed of Ir.field
  | Elapsed of Ir.field  (** local time *)
  | Integrated of { value : Ir.field; input : Ir.field }
  | Differentiated of { value : Ir.field; input : Ir.field }
  | Kept of Ir.field
      (** a costly static value, computed by reset; for each such signal,
          whether or not the step turns out to read it *)

val memory : t -> Flow.Ir.signal -> memory option
val instance : t -> Flow.Ir.instance -> Ir.field option

val is_static : t -> Flow.Ir.atom -> bool
(** Known when the node starts. *)

val fields : t -> Ir.field list
(** All, in the order of the node's equations, then its instances. *)

val new_field : t -> name:string -> Ir.content -> purpose:string -> Basis.Span.t -> Ir.field
