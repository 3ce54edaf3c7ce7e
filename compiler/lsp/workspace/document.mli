(** A text that is open in the editor. *)

type version = {
  view : View.t;
  whole : bool;  (** false if it contains only the valid parts of the text *)
  mutable since : Shift.t;  (** the edits from this version to the current text *)
}

type t = {
  uri : string;
  path : string;
  mutable version : Basis.Json.t;
  mutable text : Text.t;
  mutable latest : Analysis.t option;
      (** analysis of the version that was checked last, which may be the current one *)
  mutable named : version option;  (** the last version in which name resolution succeeded *)
  mutable typed : version option;  (** the last version in which type checking succeeded *)
  mutable changed : bool;  (** changed since it was last checked *)
  mutable slow : bool;  (** checking it would keep other requests waiting too long *)
}

val opened : uri:string -> version:Basis.Json.t -> string -> t
val change : t -> Text.t -> unit

(** {1 Checking} *)

type found = {
  analysis : Analysis.t;
  whole_view : View.t option;
  partial_view : View.t option;
      (** from {!Analysis.partial}, if this version and all earlier ones had errors *)
}
(** The analysis of the current text. *)

val found :
  t ->
  declared:Mentions.declared Text_cache.t ->
  partial:(Analysis.t -> Analysis.t) ->
  Analysis.t ->
  found
(** Does not change the document. *)

val prepare : found -> unit
(** Precomputes the data that the next request will need, so that the request can be answered
    immediately. *)

val looked_at : t -> found -> unit
val names : t -> View.seen option
val types : t -> View.seen option
