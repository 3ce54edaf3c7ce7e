(** What was built, kept from one run to the next: in [XDG_CACHE_HOME], or [~/.cache].

    What is there will be run, so only a folder is trusted that is the user's own and that nobody
    else may write. Without one, what is built goes when the command has ended. *)

val entry :
  name:string ->
  key:string ->
  suffix:string ->
  reuse:bool ->
  (folder:string -> string -> (unit, string) result) ->
  (string, string) result
(** [entry ~name ~key ~suffix ~reuse make] is the path of an entry. [key] is a digest of all that it
    depends on, [name] the beginning of its file's name. With [reuse] an entry that is whole is
    taken as it is; else [make ~folder path] is to put it at [path], and may work in [folder]. The
    error is a text for the user: [make]'s, or why nothing could be written. *)
