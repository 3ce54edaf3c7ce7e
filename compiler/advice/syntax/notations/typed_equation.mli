(** Equations that start with a type, as declarations do in C: [Velocity v = 0.3[m/s]]. *)

type t = {
  first : int;  (** the index of the first word in the line *)
  start : int;  (** the index of the type *)
  stop : int;  (** the index of the name that the equation defines *)
  type_ : string;  (** the type, without words such as [const] *)
  name : string;
  sign : string;  (** [=], or [<-] in a [do] *)
  value : string;  (** the right-hand side, or [""] if it is on the next line *)
  in_a_let : bool;  (** does the line start with [let]? *)
}

val of_line : string -> t option
(** The equation on this line, if its type starts with a capital letter. *)

val of_colon : string -> t option
(** [v: Velocity = 0.3[m/s]], as in Python. *)

val of_c : string -> t option
(** [float v = 2 * x], with a C type, [var] or [auto]. *)

val without_type : t -> string
(** The hint that suggests only the equation. *)

val advice : t -> string
(** The hint that suggests the equation, and its signature. *)

val alone : string -> string option
(** [v :: Velocity] for a line [Velocity v;]. *)

val pairs : string list -> (string * string) list option
(** The types and names in a list of words such as [Float x Float y]; [None] for any other list. *)

val of_words : string -> string option
(** The hint for parameters that follow their types, without parentheses or with a result type:
    [half Float x = x / 2], [Float half(Float x) = x / 2]. *)

val of_parameters : string -> string option
(** The hint for the definition [f (Float x, Int n) = …]. *)
