(** The facts that the checks of Core report, as data without any message text. [Advice] translates
    each fact into a diagnostic. *)

open Basis

type cause =
  | Itself  (** the definitions mention each other *)
  | Methods of { default : (Ir.Global.t * Ir.ty) option }
      (** at least one of the uses goes through a method. [default]: if a default definition is part
          of the cycle, its class and the type for which it is used *)

type use = { index : int; by : Ir.Global.t; types : Ir.ty list; at : Span.t }
(** A use of the definition whose number is [index] and whose name is [by], at these types. *)

type t =
  | Cycle of { cycle : (Ir.definition * Span.t) list; cause : cause }
      (** Each definition needs the next one, and the last one needs the first. Each is paired with
          the place where it uses the next one. *)
  | Growing_types of { definition : Ir.definition; at : Span.t }
      (** the definition uses itself through methods at ever larger types; [at] is the place of such
          a use *)
  | Too_many_types of { definition : Ir.definition; combinations : int }
      (** definitions that use methods are needed at more than [combinations] combinations of types
      *)
  | Larger_type of {
      definition : Ir.definition;
      use : use;
      ty : Ir.ty;
      way : (Ir.definition * use) list;
    }
      (** the definition restarts itself, or another definition in its cycle, at the larger type
          [ty]. [way]: the uses that lead from the restarted definition back to this one *)
