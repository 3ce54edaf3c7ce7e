(** Combines the outputs of a machine's modes into the output of the machine.

    The output of each mode is a tuple of leaves. If the output type contains functions, modes may
    return values with different skeletons, called {e variants}. Then each mode outputs the number
    of its variant and the leaves of all variants, with zeros for the variants that it does not use.
    The machine's node selects the variant by its number. *)

open Basis

type given = {
  node : Node.t;  (** the node of the mode *)
  place : Span.t;
  value : Value.t;  (** the output of the mode, in terms of the node's signals *)
}

type leaves
(** The leaves of one mode's output. *)

type variant
(** A skeleton that at least one mode returns. *)

val leaves : Context.t -> Core.Ir.ty -> given -> leaves
(** The leaves of an output of this type. *)

val variants : given list -> leaves list -> variant list
(** The distinct skeletons among the modes' outputs. Empty if any value is acceptable in every mode.
*)

val of_mode : Context.t -> variant list -> given -> leaves -> (string * Flow.Ir.atom) list
(** The outputs of a mode's node, named by their paths. *)

val of_machine :
  Context.t -> Node.t -> span:Span.t -> Core.Ir.ty -> variant list -> Value.t * Flow.Ir.signal list
(** The machine's output, which has this type, in terms of the signals of the machine's node. Also
    returns the signals of that node that receive the outputs of {!of_mode}, in the same order. *)
