(** The facts that a stage of the compiler reports.

    Each stage defines its own type of facts. A fact says what is wrong, with the spans, trees and
    types involved, but without any text. The library [advice] turns each fact into a diagnostic. It
    does this as soon as the fact is reported, so the diagnostic describes the state of the compiler
    at that time. For example, type inference does not have to copy the types in its facts, although
    it later changes their variables. *)

type 'fact t
(** A sink for the facts that a stage reports. *)

val into : Diagnostic.sink -> ('fact -> Diagnostic.t) -> 'fact t
(** Emits the diagnostic of each fact into the sink. *)

val into_several : Diagnostic.sink -> ('fact -> Diagnostic.t list) -> 'fact t
(** Like {!into}, but for facts about several places, such as all unknown names of a module. *)

val ignored : unit -> 'fact t
(** Discards all facts. *)

val map : ('a -> 'b) -> 'b t -> 'a t
(** A sink for a stage that runs inside another stage. It wraps each reported fact in a fact of the
    outer stage. Calling {!hold} on the outer stage's sink does not hold the facts reported to this
    sink. *)

val report : 'fact t -> 'fact -> unit

val report_warning : 'fact t -> 'fact -> unit
(** Reports a warning. Warnings are never held: a caller holds facts to explain an error better, and
    a warning is valid regardless of that explanation. *)

val has_errors : 'fact t -> bool
(** Does the sink contain an error? Held facts do not count. Always false for {!ignored}. *)

(** {1 Holding facts}

    The caller of a function may know more about a problem than the function that finds it. The
    caller can then hold the facts that the function reports, and pass each one on, drop it, or
    replace it with another fact, which may contain the held one. *)

type 'fact held
(** A reported fact that has not been passed on yet, with the diagnostic that was built when it was
    reported. *)

val hold : 'fact t -> (unit -> 'a) -> 'a * 'fact held list
(** Runs the function, and returns the facts that it reported, in order, instead of passing them on.
    If the function raises an exception, its facts are passed on. *)

val fact : 'fact held -> 'fact

val is_within : Span.t list -> 'fact held -> bool
(** Is each diagnostic of this fact located within one of these spans? False if the fact has no
    diagnostic. *)

val pass_on : 'fact t -> 'fact held -> unit
(** Reports the held fact, with the diagnostic that it already has. *)

val diagnostic : 'fact held -> Diagnostic.t
(** The diagnostic of the held fact. Only [advice] uses this function, to extend the diagnostic. *)
