(** The source text before and after an unknown name, for messages. *)

open Basis

type unit_ = {
  number : string;  (** the number before the unit *)
  measure : string;  (** the unit, such as [m/s] *)
  whole : Span.t;  (** the number and the unit *)
  is_first : bool;  (** whether the unit begins with the name *)
}

val line_of : string -> Span.t -> string
(** The line on which the place starts. *)

val unit_after_number : text:string -> is_unit:(string -> bool) -> Span.t -> unit_ option
(** The unit that contains the name, if the unit follows a number and has no brackets, as in
    [0.5 m/s]. *)

val number_with_unit : text:string -> Span.t -> (string * Span.t) option
(** For a name alone in its brackets, as in [20[h]]: the number before the brackets, and the place
    of the number together with the brackets. *)

val before : text:string -> Span.t -> char
(** The character before the name. *)

val after : text:string -> Span.t -> char
(** The character after the name. *)

val follows : text:string -> string -> Span.t -> bool
(** Does the name directly follow this text? *)

val is_index : text:string -> Span.t -> bool
(** Is the name an index, such as [k] in [x(k - 1)] for an earlier sample of a signal? *)

val starts_an_equation : text:string -> string -> bool
(** Does a line of the text begin with this name and [=]? *)

val call : text:string -> Span.t -> (Span.t * string) option
(** The call that begins with the name and has parentheses, as in [pow(x, 2)], and the same call in
    Frob. [None] if the call in Frob begins with the same name. *)

val lower_case : string -> string
(** The name of a value that was written like a constructor: [speed] for [Speed], [maxSpeed] for
    [MAX_SPEED]. *)

val field : text:string -> Span.t -> Span.t option
(** The place of the name together with the field after it, as in [math.sin]. *)

val member : text:string -> Span.t -> Span.t option
(** The place of the name together with all names joined to it by dots, as in [np.linalg.norm]. *)

val written : text:string -> Span.t -> string
(** The text at this place, which must be on one line. *)

val without_modules : string -> string -> string
(** The expression with the module's functions replaced by Frob's: [abs a] for [math.fabs a]. *)

val is_an_argument : text:string -> Span.t -> bool
(** Does the name follow a function or another argument? *)

val equation : text:string -> Span.t -> string option
(** The line of the name, if it is an equation that begins with the name. *)

val definition : text:string -> Span.t -> (string * bool) option
(** The name that begins the top-level definition around this place, and whether this definition
    contains a [where]. *)

val signature : text:string -> Span.t -> string option
(** The line with the type signature of the top-level definition around this place. *)

val unit_of_literal : text:string -> Span.t -> (string * string * string) option
(** The digits before the brackets that contain the name, and the text before and after the name
    inside these brackets. For [h] in [20[km/h]], these are [20], [km/] and the empty string. *)

val assigned : text:string -> Span.t -> (string * string * Span.t) option
(** The equation that contains the name, if it is on one line: the name that it defines, its
    right-hand side, and the place of the right-hand side. *)

val divided_difference : text:string -> Span.t -> (Span.t * string) option
(** The quotient [(x - y) / dt] that ends with the name [dt]: its place, and the text of [x], with
    parentheses if it needs them as an argument. *)

val product : text:string -> Span.t -> (Span.t * string * string) option
(** The product of the name and another name: the place of the product, and the two names. [None] if
    the product is part of a longer one. *)

val record : text:string -> Span.t -> (Span.t * (string * string) list) option
(** The record expression on one line that begins with this name: its place, and the names and the
    values of its fields. *)

val in_parentheses : text:string -> Span.t -> (Span.t * string) option
(** The call that begins with the name, as in [f(x, y)], if there is no space before the
    parenthesis: the place of the call, and the text in the parentheses. *)

val application : text:string -> Span.t -> (Span.t * string list) option
(** The application of the name to arguments on its line: its place, and the text of each argument.
    Each argument is a name, a number or an expression in parentheses. *)

val arguments : text:string -> Span.t -> (Span.t * string list) option
(** Like {!application}, but also accepts arguments in parentheses, as in [f(x, y)]. *)
