(** The headers of the user's that C files need: what they include in quotes, and what that includes
    in turn. *)

val read : string -> (string, string) result
(** A file; the error says why it cannot be read. *)

type t = {
  path : string;  (** where it is *)
  name : string;  (** relative to the files that include it, as they stand in one folder *)
}

val of_sources : string list -> (t list, string) result
(** Those that are found beside these files. Others are taken for headers of the runtime or for
    generated ones. The error says of a file that cannot be read, or that includes what is outside
    its folder. *)

val of_text : folders:string list -> string -> (t list, string) result
(** Likewise of a generated file, whose includes are in these folders. *)
