(** A cache of build results in [XDG_CACHE_HOME] or [~/.cache].

    Since cached files are executed, the folder must belong to the user, and other users must not
    have write permission. Otherwise, results are deleted when the command ends. *)

val entry :
  name:string ->
  key:string ->
  suffix:string ->
  reuse:bool ->
  (folder:string -> string -> (unit, string) result) ->
  (string, string) result
(** [entry ~name ~key ~suffix ~reuse make] returns the path of an entry. [key] is a digest of
    everything that the entry depends on; the entry's file name starts with [name]. If [reuse] is
    true, a complete entry is reused. Otherwise, [make ~folder path] must create it at [path]; it
    may use [folder] for temporary files. The error is a message for the user: the error that [make]
    returned, or the reason why the entry could not be written. *)

val is_kept : unit -> (string, string) result
(** [Ok] with the cache folder. If that folder cannot be used, [Error] with its name; results are
    then deleted when the command ends. *)
