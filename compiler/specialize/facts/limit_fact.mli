(** Programs that are too large to compile, and the probable causes. *)

open Basis

type machine = { of_ : string; modes : int }
(** The state machine of this definition, and the number of modes found so far. *)

type excess =
  | Calls_nested of int  (** nested more than this many levels deep *)
  | Specializations of { name : string; limit : int; inside : machine option }
      (** more than [limit] specializations. [inside]: the surrounding machine, if most of them are
          its modes *)
  | Elements of { numbers : int list; by : string }
      (** an array of functions. [numbers]: the sizes of nested arrays, outermost first *)
  | Modes of machine
  | Wide of { ty : Core.Ir.ty; leaves : int; uses : int }
      (** more than [uses] equations and calls define values of this type *)
  | Copies of { name : string; copies : int }  (** more than [copies] specializations *)
  | Work of { definition : Core.Ir.definition; most_called : (string * int) option }
      (** no particular cause was found. [most_called]: the name that was called most often *)
  | Leaves of { ty : Core.Ir.ty; limit : int }
      (** a type whose values consist of more than [limit] numbers *)
  | Data_nested of { ty : Core.Ir.ty; limit : int }
      (** a type with more than [limit] nested levels *)
  | Functions_nested of Core.Ir.definition
      (** functions that capture functions, nested too deeply *)

type t = { at : Span.t; calls : Calls.t; excess : excess }
