(** Keeps comments when fixes are applied: writes back the comments in the text that a fix removes.
*)

val fix : Source.t -> Diagnostic.fix -> Diagnostic.fix option
(** Extends the fix so that it keeps the comments in the text it removes. They follow the
    replacement, each on its own line if whole lines are removed. A comment that another edit of the
    fix already contains is not added again. [None] if a doc comment would be moved, because it
    could then document the wrong declaration. *)

val code : string -> string
(** The text before the first comment in a piece of a program, without surrounding whitespace. *)
