(** Random programs, several in one module.

    The module's input type is one for all; [main] runs all of them side by side, so one compilation
    by the C compiler tests them all. *)

val make :
  ?seen:Coverage.t ->
  ?sees:bool ->
  ?with_tests:bool ->
  seed:int ->
  first:int ->
  count:int ->
  unit ->
  string
(** [count] programs, from the one with the number [first]: each depends only on the seed and its
    own number. What stands in them is added to [seen]. With [sees] some look through a camera
    ({!Seeing}), and need the kernels of vision. Without tests, those that some programs come with
    ({!is_tried}) are left out, and nothing else is another line. *)

val is_tried : int -> bool
(** Whether programs of that number may come with a test or a trial. *)

val observed : seed:int -> first:int -> count:int -> string * (string * Trying.observer) list
(** Likewise programs, each with a test that must be judged as the signal function beside it has it,
    which is named here ({!Trying.reference}). They assert nothing themselves. *)

val alone : seed:int -> int -> component:int -> string
(** One program, of whose signals only this one comes out. *)

val signals : seed:int -> int -> int
(** How many components the output of a program has. *)
