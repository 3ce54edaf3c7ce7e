(** A trace as a picture, in SVG: numbers as lines over the time, those of one unit in one panel;
    truth, modes and other data as bands; events as dots.

    A line has a gap where its cells are empty. Colours are such that colour-blind people tell them
    apart, and lines differ in their dashes too. *)

type column = {
  name : string;
  unit_ : string;  (** [m/s], or empty *)
  cells : string array;  (** one for each instant *)
}

(** {1 Parts of it, for other pictures} *)

type frame = { low : float; high : float; from : float; upto : float }
(** Numbers from [low] to [high] are at places from one to the other. *)

val place : frame -> float -> float

val range : float list -> float * float
(** Of numbers, with a margin, also where they are all the same. *)

val ticks : float -> float -> about:int -> float list
(** Round numbers in between, about so many. *)

val number : float -> string

val line : Buffer.t -> ?colour:string -> float -> float -> float -> float -> unit
(** From x and y to x and y. *)

val text : Buffer.t -> ?anchor:string -> ?colour:string -> float -> float -> string -> unit

(** {1 The picture} *)

val svg : times:float array -> column list -> string
(** The times are in seconds, one for each instant. *)
