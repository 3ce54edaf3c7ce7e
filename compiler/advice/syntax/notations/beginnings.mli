(** Words that begin a line in other languages, and their equivalents in Frob. *)

val by_equation : string

val no_end : string
(** The hint for a line that consists of [end]. *)

val no_procedures : string

val of_word : string -> string option
(** The hint for a line that begins with this word. *)

val of_record : string
(** The first words of the hint {!declare_a_record}. *)

val declare_a_record : string -> string
(** The hint that suggests this declaration of a record. *)

val rounds : string -> string option
(** The number of iterations of the loop that begins on this line, if it is a counted loop. *)

val repeated : string -> string
(** The hint for a loop with this number of iterations in a task. *)

val no_ranges : string -> string
(** The hint for a range such as [1..10], given as text without spaces. *)

val waiting : string
(** The hint that explains how to wait. *)

val waits : string -> bool
(** Does a statement that begins with this word wait, in Frob or in another language? *)

val needless : string list
(** Superfluous words before a definition: [const], [var] and similar ones. *)

val is_forever : string -> bool
(** Does the line begin an infinite loop, as in [while True do]? *)

val forever : string
(** The hint for an infinite loop. *)
