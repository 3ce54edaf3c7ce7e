(** Compressed files. Files with the extension [.gz] or [.zst] are read and written through [gzip]
    or [zstd], which run as separate processes. Hosts do the same ([runtime/hosts/common/packed.h]).
    All other files are used unchanged. *)

val stem : string -> string
(** The name without [.gz] or [.zst]. *)

(** {1 Reading} *)

val with_input :
  ?damaged:(string -> unit) ->
  string ->
  (in_channel -> ('a, string list) result) ->
  ('a, string list) result
(** Opens the file, unpacks it if necessary, and returns the result of the reader. If the archive
    turns out to be truncated or damaged, calls [damaged] with the reason; without [damaged],
    returns an error instead of the reader's result. *)

val read : most:int -> string -> (string, string) result
(** The whole content, unpacked; an error if it is larger than [most] bytes. *)

(** {1 Writing} *)

type writer = { channel : out_channel; close : unit -> unit }

val writer : ?named:string -> string -> writer
(** Creates or overwrites the file. Compresses the content if [named], by default the path, ends in
    [.gz] or [.zst]. Opening, writing and closing raise [Sys_error]. *)

val packed : named:string -> string -> (string, string) result
(** The bytes to write to a file with this name: the text, compressed if the name ends in [.gz] or
    [.zst]. *)
