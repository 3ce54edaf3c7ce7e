(** The facts that specialization reports, as values without text. [Advice] translates each of them
    to a diagnostic. All of them are errors. *)

open Basis

type t =
  | Recursion of Core.Fact.t
  | Limit of Limit_fact.t
  | Restart of Restart_fact.t
  | Control of Control_fact.t
  | Entry of Entry_fact.t
  | Foreign_name of foreign_name
  | Outside of { at : Span.t; calls : Calls.t; index : int; size : int }
      (** the index is out of range for an array of this size; the size depends on the call *)
  | Stored of { at : Span.t; calls : Calls.t; ty : Core.Ir.ty; by : (string * Span.t) option }
      (** a [delay] of a value that contains a function. [by]: the call in the program's own folder
          that leads to this [delay], unless the [delay] itself is in that folder; [calls]: the
          calls that lead to [by] *)
  | Of_the_instant of { at : Span.t; calls : Calls.t; ty : Flow.Ir.foreign_type }
      (** a value of this type would be stored, although it is valid for only one instant *)

(** A name in the user's C code that also occurs in the generated C. *)
and foreign_name = Function_or_component of Core.Primitive.foreign | Header of Core.Ir.header
