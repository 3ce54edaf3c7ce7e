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

    Columns are counted in characters. A place in a file whose text is not in the {!Source} table is
    shown without an excerpt. *)

val diagnostic : colour:bool -> Source.t -> Diagnostic.t -> string
(** The text ends with a newline. Colours use ANSI escape sequences. *)

val diagnostics : colour:bool -> Source.t -> Diagnostic.t list -> string
(** The first 100 errors, then the first 100 warnings, each followed by an empty line, and, if there
    are any diagnostics, {!summary}. The limits bound the running time: each error on a line of a
    million characters requires a scan of that line. *)

val first_of_each : most:int -> Diagnostic.t list -> Diagnostic.t list
(** The first [most] errors and the first [most] warnings, in list order. *)

val summary : Diagnostic.t list -> string
(** The number of errors and of warnings, for example [2 errors, 1 warning], with a newline; [""] if
    there are no diagnostics. Also says if {!diagnostics} prints only some of the diagnostics. *)
