(** The index of [!], which the compiler must know: a number written out, a name of one, or
    [+ - * div mod min max] of such. *)

open Basis

type constants
(** The values of names, as they come up. *)

val create : Ir.param list -> constants
val local : constants -> Ir.Local.t -> Ir.expr -> unit
val global : constants -> Ir.Global.t -> Ir.expr -> unit

(** Why an index is not known, and where. *)
type problem =
  | Variable of Ir.Local.t * Span.t  (** a parameter, or what depends on one *)
  | Param of Ir.Global.t * Span.t  (** of the program, named there *)
  | Computed of Span.t  (** by something else than arithmetic *)

val value : constants -> Ir.expr -> (int32, problem) result
