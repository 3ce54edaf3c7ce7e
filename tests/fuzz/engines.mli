(** The same program and input through the interpreter and the compiled C. *)

type tools = {
  library : string;  (** the folder of the standard library *)
  headers : string;
  trace_host : string;
  folder : string;  (** for files on the way *)
}

type outcome =
  | Agree
  | Rejected of string  (** the diagnostics *)
  | Failed of string  (** the C compiler or an engine reports an error *)
  | Differ of { row : int; column : string; c : string; interpreted : string }
      (** the first difference; the row counts from 0 *)

val describe : outcome -> string
(** What a program does, in words that follow its name. *)

val compare : tools -> Random.State.t -> rows:int -> entry:string -> string -> outcome
(** Of a file, on two recordings, one tame and one wild. *)
