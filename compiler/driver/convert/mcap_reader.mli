(** Reads the MCAP that {!Mcap_writer} has written, from its beginning to its end. *)

type record =
  | Attachment of { name : string; copy : out_channel -> unit }
      (** [copy], if it is called at once, writes its content. *)
  | Message of { topic : string; data : string }

val iter : string -> (record -> (unit, string) result) -> (unit, string) result
(** Each of the file, as long as all is well. The errors name the file. Raises [Sys_error]. *)
