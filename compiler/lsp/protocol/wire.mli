(** Messages on a stream, each behind a header with its length.

    What is no header is skipped up to the next one, so that whatever is sent, later messages are
    understood. *)

type t

val create : Unix.file_descr -> t

type event =
  | Message of string  (** a body; whether it is JSON is not looked at *)
  | Nothing  (** no whole message is there yet *)
  | End  (** and none will come *)

val next : t -> timeout:float -> event
(** Waits so many seconds for a message, or for ever with a negative number. *)

val write : out_channel -> Basis.Json.t -> unit
