(** Counts the numbers inside the functions that a closure has captured.

    Numbers that the closure has captured directly do not count: the count of [wallFollow 0.2] is
    zero, that of [delay 1 >>> delay 2] is two. *)

type table
(** A cache for the counts of closures. It makes the total time linear. *)

val table : Types.table -> limit:int -> table

val are_many : table -> Value.closure -> bool
(** Does the count exceed the limit? A function that occurs twice counts twice. *)
