(** All that the server knows: folders, open texts, settings. *)

open Basis

type t = {
  library : string;  (** the folder of the standard library *)
  disk : string -> (string, Resolve.Files.error) result;  (** files that are not open *)
  documents : (string, Document.t) Hashtbl.t;  (** by URI *)
  mutable encoding : Text.encoding;
  mutable roots : string list;
  mutable inlay_hints : bool;
  mutable snippets : bool;  (** the editor knows them *)
}

val create : ?disk:(string -> (string, Resolve.Files.error) result) -> library:string -> unit -> t

val read : t -> string -> (string, Resolve.Files.error) result
(** The text of a file, as it is in the editor if it is open there. *)

val document : t -> string -> Document.t option
val check : t -> path:string -> string -> Analysis.t

val analysis_of : t -> string -> Analysis.t option
(** Of a file that need not be open. *)

val look : t -> Document.t -> unit
(** Brings what is known of the text up to date. *)

val files : t -> string list
(** The programs in the folders, and those that are open. *)

(** {1 What editors are told} *)

val position : t -> Text.t -> int -> Json.t
val range : t -> Text.t -> int * int -> Json.t

val offset : t -> Text.t -> Json.t -> int
(** Of a position of the protocol. *)

val offsets : t -> Text.t -> Json.t -> int * int
(** Of a range. *)

val span_range : t -> Source.t -> Span.t -> Json.t

val location : t -> Source.t -> Span.t -> Json.t
(** Of a place in a file of a program, whose texts these are. *)

val uri_of : t -> string -> string
(** Of the file that spans call so. *)
