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
    everything that it depends on; [name] is the start of its file name. If [reuse] is true, a
    complete entry is reused. Otherwise, [make ~folder path] must create it at [path]; it may use
    [folder] for temporary files. The error is a text for the user: the error of [make], or the
    reason why nothing could be written. *)

val is_kept : unit -> (string, string) result
(** [Ok] with the folder of the cache, or [Error] with the folder that cannot be used. In the latter
    case, results are deleted when the command ends. *)
