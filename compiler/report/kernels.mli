(** Costs of the library's vision kernels ([runtime/include/frob/vision.h]). *)

(** How to compute the number of pixels that a call reads. Except for the numbers of samples, the
    fields are indices into the leaves of the call's arguments.

    - [Region]: width times height.
    - [Line]: length times width.
    - [Iterated]: [samples] pixels at each level, once at the start and once in each iteration.
    - [Samples]: a fixed number. *)
type looks =
  | Region of { width : int; height : int }
  | Line of { length : int; width : int }
  | Iterated of { samples : int; level : int; iterations : int }
  | Samples of int

type t = { looks : looks; stack : int  (** in bytes *) }

val find : string -> t option
(** Looks up a kernel by its C name. *)

val pixels : looks -> Step.Ir.expr list -> int option
(** Maximum number of pixels that a call with these arguments reads; [None] if it may read the whole
    image. *)
