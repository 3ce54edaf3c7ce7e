(** A text that is open in the editor. *)

type version = {
  view : View.t;
  whole : bool;  (** or only what was right in it *)
  mutable since : Shift.t;  (** to the text as it is *)
}

type t = {
  uri : string;
  path : string;
  mutable version : Basis.Json.t;
  mutable text : Text.t;
  mutable latest : Analysis.t option;  (** of the text as it is, or was when last looked at *)
  mutable named : version option;  (** the last one in which names were right *)
  mutable typed : version option;  (** the last one in which types were *)
  mutable changed : bool;  (** since it was looked at *)
}

val opened : uri:string -> version:Basis.Json.t -> string -> t
val change : t -> Text.t -> unit

val looked_at : t -> partial:(Analysis.t -> Analysis.t) -> Analysis.t -> unit
(** [partial] is asked if there never was a version without mistakes. *)

val names : t -> View.seen option
val types : t -> View.seen option
