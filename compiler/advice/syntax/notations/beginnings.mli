(** Words that begin a line in other languages, and their equivalents in Frob. *)

open Basis

val by_equation : Diagnostic.hint

val no_end : Diagnostic.hint
(** The hint for a line that consists of [end]. *)

val no_procedures : Diagnostic.hint

val of_word : string -> Diagnostic.hint option
(** The hint for a line that begins with this word. *)

val declare_a_record : string -> Diagnostic.hint
(** The hint that suggests this declaration of a record. *)

val rounds : string -> string option
(** The number of iterations of the loop that begins on this line, if it is a counted loop. *)

val repeated : string -> string
(** The hint for a loop in a task, with this number of iterations. *)

val no_ranges : string -> string
(** The hint for a range such as [1..10], given as text without spaces. *)

val waiting : Diagnostic.hint
(** The hint that explains how to wait. *)

val waits : string -> bool
(** Does a statement that begins with this word wait, in Frob or in another language? *)

val needless : string list
(** Superfluous words before a definition: [const], [var] and similar ones. *)

val is_forever : string -> bool
(** Does the line begin an infinite loop, as in [while True do]? *)

val forever : string
(** The hint for an infinite loop. *)
