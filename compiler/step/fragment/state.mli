(** The fields that a node's equations and instances need. *)

type t

val of_node : callee:(int -> Ir.node) -> statics:(int -> Ir.variable list) -> Statics.t -> t
(** Of the nodes before this one: the nodes themselves, and their statics. *)

type memory =
  | Delayed of Ir.field
  | Elapsed of { time : Ir.field; restart : Flow.Ir.atom }
  | Ticked of { time : Ir.field; period : Flow.Ir.atom }  (** since the last tick *)
  | Integrated of { value : Ir.field; input : Ir.expr }
      (** [input]: the last one, which is a field, or a number for ever *)
  | Differentiated of { value : Ir.field; input : Ir.field }
  | Kept of Ir.field  (** a costly static value, computed by reset *)

val past_first : string
(** The purpose of a Bool that is false up to the end of the first instant. *)

val memory : t -> Flow.Ir.signal -> memory option
val instance : t -> Flow.Ir.instance -> Ir.field option

type machine = { clock : Ir.clock option; modes : Ir.mode list }
(** What a machine keeps. *)

val machine : t -> machine option

val modes : t -> Ir.mode list
(** Of the machine, if there is one. *)

val fields_of_mode : Ir.mode -> Ir.field list
(** Its parameters and its state. *)

val fields : t -> Ir.field list
(** All, in the order of the step's items, then what is kept. *)
