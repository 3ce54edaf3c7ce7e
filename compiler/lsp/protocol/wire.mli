(** Reads and writes messages on a stream, each with a header that contains its length.

    The reader skips anything that is not a header, so it recovers from malformed input. *)

type t

val create : Unix.file_descr -> t

type event =
  | Message of string  (** the body, which may not be valid JSON *)
  | Nothing  (** no complete message has arrived yet *)
  | End  (** end of the stream *)

val next : t -> timeout:float -> event
(** Waits up to [timeout] seconds for a message, or without limit if [timeout] is negative. *)

val wait : t -> Unix.file_descr list -> Unix.file_descr list
(** Waits until a message may be available or one of these descriptors is readable. Returns the
    descriptors that are readable. *)

val write : out_channel -> Basis.Json.t -> unit
