(** A trace as a picture, in SVG: numbers as lines over the time, those of one unit in one
    panel; truth, modes and other data as bands; events as dots.

    A line has a gap where its cells are empty. Colours are such that colour-blind people
    tell them apart, and lines differ in their dashes too. *)

type column = {
  name : string;
  unit_ : string;  (** [m/s], or empty *)
  cells : string array;  (** one for each instant *)
}

val svg : times:float array -> column list -> string
(** The times are in seconds, one for each instant. *)
