(** Hints about lines that are indented too little or too much. *)

open Basis

val of_where : Found.rule
(** A `where` at the left margin. *)

val equations_before_output : Found.t -> Diagnostic.hint option
(** Equations below `proc i ->`, and the output below them. *)

val not_indented : Found.rule
(** A definition that continues at the left margin. *)

val misplaced_line : Found.rule
(** A line that starts at a different column than the items of its block. *)

val without_braces : Found.t -> Diagnostic.hint
(** The hint for the opening brace of a block. *)
