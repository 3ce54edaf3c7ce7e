(** Draws a trace as SVG: numbers as lines over time, those with the same unit in one panel; Bools,
    modes and other data as bands; events as dots.

    A line has a gap where its cells are empty. The colours are suitable for colour-blind readers,
    and lines also differ in their dashes. *)

type column = {
  name : string;
  unit_ : string;  (** such as [m/s]; empty if the column has no unit *)
  cells : string array;  (** one for each instant *)
}

(** {1 Functions for other pictures} *)

type frame = { low : float; high : float; from : float; upto : float }
(** A scale that maps numbers from [low] to [high] to coordinates from [from] to [upto]. *)

val place : frame -> float -> float

val range : float list -> float * float
(** The range of the numbers with a margin. Not empty even if all numbers are equal. *)

val ticks : float -> float -> about:int -> float list
(** The ticks of an axis: round numbers between the limits, approximately [about] of them. *)

val number : float -> string

val line : Buffer.t -> ?colour:string -> float -> float -> float -> float -> unit
(** Draws a line between two points, each given as x and y. *)

val text : Buffer.t -> ?anchor:string -> ?colour:string -> float -> float -> string -> unit

(** {1 The picture} *)

val svg : times:float array -> column list -> string
(** The times are in seconds, one for each instant. *)
