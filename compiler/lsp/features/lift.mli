(** What a code action needs to make a definition inside another one of the top level. *)

type t = {
  name : string;
  edits : ((int * int) * string) list;  (** places in the text, as offsets, and what comes there *)
}

val at : Workspace.t -> Document.t -> View.t -> int * int -> t option
(** Of the local definition whose name is there, in a text without mistakes that the view is of.
    What it knows from around it comes to be its parameters. The changed text has been checked:
    [None] if something would be wrong in it, or if the name means something else already. *)
