(** The same program and input through the interpreter and the compiled C. *)

type tools = {
  library : string;  (** the folder of the standard library *)
  runtime : string;  (** the runtime's sources: [include], [core], [hosts] *)
  folder : string;  (** for files on the way *)
  real : Basis.Real.t;  (** what the program computes with *)
  probed : bool;  (** C shows inner signals too, which must change nothing *)
}

(** What runs the C. *)
type c_engine = Tcc  (** in this process, in no time *) | Sanitized of Sanitized.compiler

type outcome =
  | Agree
  | Rejected of string  (** the diagnostics *)
  | Failed of string  (** an engine or the C compiler reports an error, or crashes *)
  | Differ of {
      by : c_engine;
      row : int;  (** of the first difference, from 0 *)
      column : string;
      c : string;
      interpreted : string;
      recording : Recording.t;
    }

val describe : outcome -> string
(** What a program does, in words that follow its name. *)

type subject
(** A program, ready for both engines. *)

val load : ?robot:Cgen.Robot.t -> tools -> entry:string -> string -> (subject, outcome) result
(** Of a file; a program that leaves its robot open is one for [robot]. *)

val judges : tools -> string -> (string list, outcome) result
(** The entries of a file that judge in its tests and trials. *)

val files : subject -> (string * string) list
(** The names and texts of its C, with the table for hosts. *)

val interpreted : subject -> Recording.t -> string
(** The trace of the output as the interpreter has it. May raise what a program of its own would
    show as an internal error. *)

val recordings : Random.State.t -> rows:int -> subject -> Recording.t list
(** A tame one and a wild one. *)

val with_dt : Random.State.t -> rows:int -> tools -> subject -> Recording.t
(** One whose steps are given any dt, as no host gives them. {!judge} leaves it to [Tcc]. *)

val fits : subject -> Recording.t -> bool
(** Whether the recording has the program's columns. *)

val read_recording : subject -> string -> (Recording.t, string) result
(** From CSV. *)

val judge : tools -> c_engine list -> subject -> Recording.t list -> outcome
(** The first disagreement. *)
