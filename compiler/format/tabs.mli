(** Tabs, which the language does not allow, for indentation counts. *)

val expanded : string -> string option
(** The text with blanks for tabs, as wide as editors show them, if it is the same program whether
    they are 4 or 8 wide, and no text of it has one. *)
