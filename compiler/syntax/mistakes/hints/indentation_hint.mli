(** Hints about lines that stand too far left or right. *)

val of_where : Found.rule
(** A `where` at the left edge. *)

val not_indented : Found.rule
(** A definition that goes on at the left edge. *)

val misplaced_line : Found.rule
(** A line that begins at another column than the items of its block. *)

val by_indentation : string
(** The hint for blocks in braces. *)
