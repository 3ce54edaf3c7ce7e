(** Loops in the notation of C, Python and MATLAB. *)

val over_array : string -> int -> string
(** The hint for the [for] at this offset or later on its line. It names the array over which the
    loop iterates. *)

type t = {
  word : string;  (** [for] or [while] *)
  first : int;  (** the offset of the word *)
  hint : string;
}

val as_value : string -> int -> t option
(** The loop that contains this offset, if the loop is the value of an equation, as in
    [total row = for x in row]. *)
