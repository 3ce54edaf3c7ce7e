(** What a machine gives, made of what its modes give.

    The output of each mode is a tuple of leaves. Where the output's type holds functions, modes may
    give values of different skeletons, its {e variants}: then every mode gives the number of its
    variant and the leaves of all, those of the others being zero, and the machine's node chooses by
    the number. *)

open Basis

type given = {
  node : Node.t;  (** the mode's *)
  place : Span.t;
  value : Value.t;  (** its output, in terms of its node *)
}

type leaves
(** of one mode's output *)

type variant
(** a skeleton that some mode gives *)

val leaves : Context.t -> Core.Ir.ty -> given -> leaves
(** of an output of this type *)

val variants : given list -> leaves list -> variant list
(** The different skeletons of all modes' outputs; none if any value would do in each mode. *)

val of_mode : Context.t -> variant list -> given -> leaves -> (string * Flow.Ir.atom) list
(** The outputs of a mode's node, with paths for names. *)

val of_machine :
  Context.t -> Node.t -> span:Span.t -> Core.Ir.ty -> variant list -> Value.t * Flow.Ir.signal list
(** The machine's output, of this type, in the node where it runs, and the signals there for what
    {!of_mode} gives, in the same order. *)
