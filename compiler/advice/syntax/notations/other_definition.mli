(** Definitions of functions and choices in the notation of C, Python or MATLAB, and their
    equivalents in Frob, which are guesses based on a few lines of source text. *)

type t = {
  head : int * int;  (** the offsets of the first line, or of its part before the body *)
  signature : string option;  (** [f :: Float -> Float] *)
  equation : string;  (** [f x = x * 2], or [f x = …] if the body is not a single expression *)
}

val of_c : string -> int -> t option
(** The C function that begins at this offset: [float f(float x) { return x; }]. *)

val of_javascript : string -> int -> t option

val of_python : string -> int -> t option
(** The Python function that begins at this offset: [def f(x): return x]. *)

val of_matlab : string -> int -> t option
(** The MATLAB function that begins at this offset: [function y = f(x)]. *)

val of_main : string
(** The hint for a function [main]. *)

val advice : t -> string
(** The hint that suggests the signature, if there is one, and the equation. *)

val choice : string -> int -> string option
(** The equation [y = if c then a else b] for the choice at this offset, if all its branches assign
    to the same name: [if c:] with lines below it, or [if (c) { y = a; }]. *)

val choice_of_values : string -> int -> string option
(** [if c then a else b] for the choice at this offset, whose branches are values: [if c:] with the
    value on the line below it, and [else:]. *)

val choice_in_braces : string -> int -> string option
(** [if c then a else b] for [if (c) { a } else { b }] at this offset. *)

val without_semicolon : string -> string
(** The text without surrounding spaces and without a semicolon at its end. *)

val in_braces : string -> int -> (string * int) option
(** The text in the braces at or after this offset, and the offset after them. *)

val record : string -> int -> string option
(** [data P = P { x :: Float }] for [struct P { float x; }], [typedef struct { float x; } P] or
    [type alias P = { x : Float }] at this offset. *)

val enumeration : string -> int -> string option
(** [data Side = Left | Right] for [enum Side { Left, Right }] at this offset. *)

val array : string -> int -> string option
(** The hint for [float gains[2] = {1.0, 0.5};] at this offset. *)

val body_of_lambda : string -> int -> string option
(** The expression at this offset, up to a comma or the closing bracket, translated into Frob. *)
