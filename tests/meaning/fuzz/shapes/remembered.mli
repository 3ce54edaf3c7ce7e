(** Events that depend on a condition's current value and on its value an instant ago.

    While a mode runs, none of its events has occurred, so the compiler knows parts of their
    conditions. If this implies that a remembered condition never changes, the compiler treats it as
    a constant. These events reveal a condition that it wrongly treats as constant. *)

val event : Scope.t -> (unit -> string) -> string
(** An expression of type [Event ()] in this scope, made with a generator of conditions. *)
