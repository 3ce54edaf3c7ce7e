(** Writes MCAP, a container format for recordings that Foxglove and other tools read. The messages
    are in uncompressed chunks, with indexes, a summary, and all CRCs
    ({{:https://mcap.dev/spec} the specification}). The output is deterministic.

    Times are in nanoseconds and must not be negative. Messages must be written in chronological
    order. Writing raises [Sys_error]. *)

type t

val start : out_channel -> t

val attach : t -> name:string -> media_type:string -> in_channel -> unit
(** Attaches a whole file. Call this before the first message. *)

val metadata : t -> name:string -> (string * string) list -> unit
(** Adds a metadata record. Call this before the first message. *)

type channel

val channel : t -> topic:string -> schema:string * string -> channel
(** Creates a channel for JSON messages. The schema consists of a name and a JSON Schema. A name
    must always be used with the same schema. *)

val message : t -> channel -> time:int -> string -> unit
val finish : t -> unit
