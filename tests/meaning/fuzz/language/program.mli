(** Generates random programs, several in one module.

    All programs of a module have the same input type. [main] runs all of them side by side, so one
    compilation by the C compiler tests them all. *)

val make :
  ?seen:Coverage.t ->
  ?sees:bool ->
  ?with_tests:bool ->
  seed:int ->
  first:int ->
  count:int ->
  unit ->
  string
(** Generates [count] programs, starting with number [first]. Each depends only on the seed and its
    own number. [seen] counts the constructs in them. With [sees] some of them use a camera
    ({!Seeing}) and need the vision kernels. With [with_tests] false, the tests that some programs
    come with ({!is_tried}) are omitted, without changing any other line. *)

val is_tried : int -> bool
(** Whether programs with this number may come with a test or a trial. *)

val observed : seed:int -> first:int -> count:int -> string * (string * Trying.observer) list
(** Generates programs that each have a test. The test's verdict must be that of the signal function
    next to it, which is returned with its name ({!Trying.reference}). The programs themselves
    contain no assertions. *)

val alone : seed:int -> int -> component:int -> string
(** One program that outputs only this one of its signals. *)

val signals : seed:int -> int -> int
(** Number of components of a program's output. *)
