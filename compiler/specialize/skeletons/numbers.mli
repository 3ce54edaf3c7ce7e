(** How many numbers are inside the functions that a closure has captured.

    Not counted are those that it has captured itself: [wallFollow 0.2] has none inside,
    [delay 1 >>> delay 2] has two. *)

type table
(** Remembers the counts of closures, so that counting is linear in all. *)

val table : Types.table -> limit:int -> table

val are_many : table -> Value.closure -> bool
(** More than the limit? What occurs twice counts twice. *)
