(** A refactoring for code actions: moves a local definition to the top level. *)

type t = {
  name : string;
  edits : ((int * int) * string) list;  (** ranges in the text, as offsets, and their replacements *)
}

val at : Workspace.t -> Document.t -> View.t -> int * int -> t option
(** The edits for the local definition whose name is at this range. The view must be of the current
    text, without errors. Local variables that the definition uses become its parameters. The
    changed text is checked: [None] if it would have errors, or if the name already has a different
    meaning at the top level. *)
