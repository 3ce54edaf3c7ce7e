(** What the library's kernels of vision need ([runtime/include/frob/vision.h]). *)

(** How many pixels a call looks at: those of a region whose width and height are these of the
    call's leaves; along a line, of its length and width; so many samples at each level, at first
    and in each iteration; or a fixed number. *)
type looks =
  | Region of { width : int; height : int }
  | Line of { length : int; width : int }
  | Iterated of { samples : int; level : int; iterations : int }
  | Samples of int

type t = { looks : looks; stack : int  (** in bytes *) }

val find : string -> t option
(** By its C name. *)

val pixels : looks -> Step.Ir.expr list -> int option
(** Of a call with these arguments, at most; [None]: as many as the image has. *)
