(** Diagnostics as text with excerpts of the source:

    {v
error[E0401]: signal `speed` needs its own value in the same instant
  --> wall_follow.frob:12:3
   |
12 |   speed = gain * err
   |   ^^^^^
13 |   err   = target - speed
   |   --- `err` reads it here
   |
   = hint: read the previous value instead, with `delay`
    v}

    Columns are shown in characters. A place in a file whose text is not in the table is shown
    without an excerpt. *)

val diagnostic : colour:bool -> Source.t -> Diagnostic.t -> string
(** Ends with a line end; colour is by ANSI sequences. *)

val diagnostics : colour:bool -> Source.t -> Diagnostic.t list -> string
(** All of them, an empty line after each, and then {!summary} if there are any. *)

val summary : Diagnostic.t list -> string
(** Such as [2 errors, 1 warning], with a line end; [""] for none. *)
