(** Keeps comments in fixes: writes back each comment in the text that a fix removes. *)

val fix : Source.t -> Diagnostic.fix -> Diagnostic.fix option
(** The fix, with the comments of each removed text after its replacement, each on its own line if
    whole lines are removed. Comments that another edit of the fix writes stay as they are. [None]
    if a comment would become documentation of something else: then the fix is not made. *)

val code : string -> string
(** The text before the first comment in a piece of a program, without surrounding blanks. *)

val in_text : string -> string list
(** The comments in a piece of a program, in order, without their line ends. *)
