(** The state of the server: folders, open documents and settings. *)

open Basis

type t = {
  library : string;  (** the folder of the standard library *)
  disk : string -> (string, Resolve.Files.error) result;  (** reads files that are not open *)
  documents : (string, Document.t) Hashtbl.t;  (** open documents, by URI *)
  mutable encoding : Text.encoding;
  mutable roots : string list;
  mutable inlay_hints : bool;
  mutable snippets : bool;  (** whether the editor supports snippets *)
  trees : Syntax.Ir.program option Text_cache.t;  (** syntax trees, by path *)
  exports : Exports.t option Text_cache.t;  (** exported names, by path *)
  declared : Mentions.declared Text_cache.t;  (** declarations, by the file name that spans use *)
  explanations : (string, string option) Hashtbl.t;
      (** for each diagnostic code, the URI of the page that explains it *)
}

val create : ?disk:(string -> (string, Resolve.Files.error) result) -> library:string -> unit -> t

val read : t -> string -> (string, Resolve.Files.error) result
(** The text of a file: the editor's version if the file is open. *)

val document : t -> string -> Document.t option
val check : t -> path:string -> string -> Analysis.t

val analysis_of : t -> string -> Analysis.t option
(** The analysis of a file, which need not be open. *)

val analyse : t -> Document.t -> Document.found
(** Does not change the document. *)

val look : t -> Document.t -> unit
(** Checks the text and updates the document. *)

val files : t -> string list
(** The paths of the programs in the workspace folders and of the open programs. *)

(** {1 Places in the protocol's format} *)

val position : t -> Text.t -> int -> Json.t
val range : t -> Text.t -> int * int -> Json.t

val offset : t -> Text.t -> Json.t -> int
(** The offset of a position in the protocol's format. *)

val offsets : t -> Text.t -> Json.t -> int * int
(** The offsets of a range in the protocol's format. *)

val span_range : t -> Source.t -> Span.t -> Json.t

val location : t -> Source.t -> Span.t -> Json.t
(** The location of a span in a program with these sources. *)

val uri_of : t -> string -> string
(** The URI of a file, given the file name that spans use. *)
