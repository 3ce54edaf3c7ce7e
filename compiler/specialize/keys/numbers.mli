(** Counts the numbers inside the functions that a closure has captured.

    Numbers that the closure has captured directly do not count: [wallFollow 0.2] has a count of
    zero, and [delay 1 >>> delay 2] a count of two. *)

type table
(** A cache for the counts of closures. It makes the total time linear. *)

val table : Types.table -> limit:int -> table

val are_many : table -> Value.closure -> bool
(** Does the count exceed the limit? A function that occurs twice counts twice. *)
