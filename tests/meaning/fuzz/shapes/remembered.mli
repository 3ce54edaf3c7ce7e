(** Events that ask what a condition is and what it was an instant ago.

    While a mode runs none of its events has occurred, so the compiler knows parts of their
    conditions; and a condition of an instant ago that this keeps as it began it takes for a
    constant. What it takes for one and is none shows where the event depends on it. *)

val event : Scope.t -> (unit -> string) -> string
(** In a scope, of what makes conditions: an expression of type [Event ()]. *)
