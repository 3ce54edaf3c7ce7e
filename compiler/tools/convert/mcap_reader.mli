(** Reads an MCAP file that {!Mcap_writer} has written, from start to end. *)

type record =
  | Attachment of { name : string; copy : out_channel -> unit }
      (** [copy] writes the content. It must be called before the next record is read. *)
  | Message of { topic : string; data : string }

val iter : string -> (record -> (unit, string) result) -> (unit, string) result
(** Calls the function for each record until it returns an error. The errors name the file. Raises
    [Sys_error]. *)

val is_ours : string -> bool
(** Whether frobc wrote the MCAP file, according to its header. Also true if the file is not an MCAP
    file. Raises [Sys_error]. *)
