(** Parses the definitions of ROS 2 message types: files with the extension [.msg]. *)

type base =
  | Truth
  | Real of int  (** bits *)
  | Whole of { bits : int; signed : bool }
  | Text
  | Message of { package : string; name : string }

type length = One | Exactly of int | At_most of int | Any

type field = {
  name : string;  (** the name in the file: [angle_min] *)
  base : base;
  length : length;
  comment : string;  (** the comment after the field or above it; [""] if there is none *)
}

type constant = { constant : string; base : base; value : string }
type t = { fields : field list; constants : constant list }

val parse : package:string -> file:string -> string -> (t, string) result
(** Parses the text of a file from this package. The error names the file and the line. *)

val type_text : field -> string
(** The field's type in ROS notation: [float32[<=8]]. *)

val is_name : string -> bool
(** Whether this can be the name of a package, a type or a field. *)

val frob_name : string -> string
(** The name of a field in a Frob record: [angleMin] for [angle_min], and [data_] for [data], which
    is a keyword in Frob. *)

val is_named : string -> field -> bool
(** Whether a field with this name in a Frob record corresponds to this field of the message. *)
