(** Evaluates the index of [!] at compile time: a number literal, a name defined as one, or
    [+ - * div mod min max] of such expressions. *)

open Basis

type constants
(** The values of names, evaluated on demand. *)

val create : Ir.param list -> constants
val local : constants -> Ir.Local.t -> Ir.expr -> unit
val global : constants -> Ir.Global.t -> Ir.expr -> unit

(** The reason why an index is not constant, and the place. *)
type problem =
  | Variable of Ir.Local.t * Span.t  (** a function parameter, or a variable that depends on one *)
  | Param of Ir.Global.t * Span.t  (** a parameter of the program, mentioned at this place *)
  | Computed of Span.t  (** something other than arithmetic *)

val value : constants -> Ir.expr -> (int32, problem) result
