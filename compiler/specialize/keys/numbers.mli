(** Counts the numbers inside the functions that a closure has captured.

    Numbers that the closure has captured itself do not count: [wallFollow 0.2] has none inside,
    [delay 1 >>> delay 2] has two. *)

type table
(** Remembers the counts of closures, so that the total time is linear. *)

val table : Types.table -> limit:int -> table

val are_many : table -> Value.closure -> bool
(** Does the count exceed the limit? A function that occurs twice counts twice. *)
