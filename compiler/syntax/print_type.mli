(** Prints names, units and types as Frob source. All functions write to a buffer. *)

open Ir

(** {1 Text and names} *)

val text : Buffer.t -> string -> unit

val separated : Buffer.t -> string -> ('a -> unit) -> 'a list -> unit
(** Prints the elements, separated by this text. *)

val between : Buffer.t -> string -> string -> (unit -> unit) -> unit
(** Prints the first text, calls the function, and prints the second text. *)

val words : Buffer.t -> (Buffer.t -> 'a -> unit) -> 'a list -> unit
(** Prints the elements, with a space before each. *)

val enclosed : Buffer.t -> string -> string -> ('a -> unit) -> 'a list -> unit
(** Prints the elements, separated by commas, between two texts such as brackets. *)

val name : Buffer.t -> name -> unit
(** Prints a name. Puts an operator in parentheses. *)

val qualified : Buffer.t -> qualified -> unit

val infix : Buffer.t -> qualified -> unit
(** Prints an operator as it appears between operands. Puts a name in backticks. *)

(** {1 Units and types} *)

val unit_to : Buffer.t -> unit_ -> unit

val factor : Buffer.t -> unit_ -> unit
(** Prints a unit as a factor of a product, in parentheses if necessary. *)

val in_brackets : Buffer.t -> unit_ list -> unit
(** Prints the units of a number or a type in brackets: [[m/s]]. *)

val type_to : Buffer.t -> ty -> unit

val simple_type : Buffer.t -> ty -> unit
(** Prints a type as a type argument, in parentheses if necessary. *)

val context : Buffer.t -> (qualified * ty) list -> unit
(** Prints the constraints of a signature and the double arrow. *)

val qualified_type : Buffer.t -> qualified_type -> unit
val signature : Buffer.t -> signature -> unit
