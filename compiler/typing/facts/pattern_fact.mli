(** Facts that {!Patterns} reports about the patterns of a typed program. *)

open Basis

type missing = {
  named : string list;
      (** some of the values, in source syntax, with [_] for any value; at least one *)
  more : int;  (** number of missing patterns beyond those in [named] *)
}
(** Values that no pattern covers. *)

type case = {
  at : Span.t;
  scrutinee : Ir.expr;
  branches : Ir.branch list;
  data : Ir.data list;  (** the program's data types *)
}

(** Constructs whose patterns must always match. *)
type refutable = Equation | Bind | Function | Proc

type t =
  | Too_complex of case  (** its patterns have too many combinations *)
  | Missing of {
      case : case;
      missing : missing;
      guarded_only : int option;
          (** the index of a branch that would cover the first of these values if it had no guards
          *)
      listed : missing option;
          (** like [missing], but with more patterns in [named]; absent if [guarded_only] is present
              or there are too many combinations to list *)
    }
  | Unreachable of { case : case; branch : Ir.branch }
  | Refutable of { pattern : Ir.pattern; of_ : refutable; missing : missing }
  | Guards_fail of { guards : Ir.expr; guarded : (Ir.expr * Ir.expr) list }
      (** guards outside a [case] that can all be false *)
