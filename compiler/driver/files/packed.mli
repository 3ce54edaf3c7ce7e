(** Files that are compressed: what is named [.gz] or [.zst] goes through [gzip] or [zstd], a
    process of its own, as in hosts ([runtime/hosts/common/packed.h]). Any other is as it is. *)

val stem : string -> string
(** The name without [.gz] or [.zst]. *)

(** {1 Reading} *)

val with_input :
  ?damaged:(string -> unit) ->
  string ->
  (in_channel -> ('a, string list) result) ->
  ('a, string list) result
(** What the reader makes of it; an archive that turns out to be cut off or damaged is an error,
    whatever that is, or is told to [damaged]. *)

val read : string -> (string, string) result
(** All of it. *)

(** {1 Writing} *)

type writer = { channel : out_channel; close : unit -> unit }

val writer : ?named:string -> string -> writer
(** Writes the file anew, compressed if it is [named] so, itself unless something else is said.
    Opening, writing and closing raise [Sys_error]. *)

val packed : named:string -> string -> (string, string) result
(** What is in a file of this name with this text. *)
