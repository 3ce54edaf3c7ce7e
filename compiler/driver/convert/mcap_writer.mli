(** Writes MCAP, the container of recordings that Foxglove and others read: messages in chunks that
    are not compressed, with indexes, a summary, and all CRCs
    ({{:https://mcap.dev/spec} the specification}). What is written depends on what it is given and
    on nothing else.

    Times are nanoseconds, from [0] on; messages come in their order. Writing raises [Sys_error]. *)

type t

val start : out_channel -> t

val attach : t -> name:string -> media_type:string -> in_channel -> unit
(** All of a file, from its beginning on, before the first message. *)

val metadata : t -> name:string -> (string * string) list -> unit
(** Likewise. *)

type channel

val channel : t -> topic:string -> schema:string * string -> channel
(** Of JSON messages; the schema is a name, which stands for the same schema each time, and its JSON
    Schema. *)

val message : t -> channel -> time:int -> string -> unit
val finish : t -> unit
