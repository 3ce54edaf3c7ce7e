(** Units that the prelude does not declare, such as [mph] and [mV], and temperatures in degrees. *)

open Basis

type t = private {
  scale : float;
  unit_ : string;  (** expressed in units of the prelude *)
  plain : bool;  (** usually a plain number in Frob, such as a count or a percentage *)
}

val find : is_unit:(string -> bool) -> string -> t option
(** The definition of the unit with this name, in units of the prelude. Recognizes common names, and
    SI prefixes before units that [is_unit] accepts. *)

val explain :
  is_unit:(string -> bool) ->
  text:string ->
  Span.t ->
  string ->
  (Diagnostic.t -> Diagnostic.t) option
(** Adds the hint for the unknown unit with this name, at this place in the text. *)
