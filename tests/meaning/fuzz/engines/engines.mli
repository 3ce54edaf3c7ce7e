(** Runs the same program and input in the interpreter and as compiled C. *)

type tools = {
  library : string;  (** the folder of the standard library *)
  runtime : string;  (** the folder of the runtime's sources: [include], [core], [hosts] *)
  folder : string;  (** for temporary files *)
  real : Basis.Real.t;  (** precision of the program *)
  probed : bool;
      (** whether the C also exposes internal signals, which must not change its output *)
}

(** A way to compile and run the C. *)
type c_engine = Tcc  (** within this process, which is fast *) | Sanitized of Sanitized.compiler

type outcome =
  | Agree
  | Rejected of string  (** the diagnostics *)
  | Failed of string  (** an engine or the C compiler reported an error or crashed *)
  | Differ of {
      by : c_engine;
      row : int;  (** row of the first difference, counted from 0 *)
      column : string;
      c : string;
      interpreted : string;
      recording : Recording.t;
    }

val describe : outcome -> string
(** The program's result, as a phrase that follows its name. *)

type subject
(** A program that is ready for both engines. *)

val load : ?robot:Cgen.Robot.t -> tools -> entry:string -> string -> (subject, outcome) result
(** Loads a program from a file. [robot] is the robot of a program that leaves it open. *)

val judges : tools -> string -> (string list, outcome) result
(** Names of the entries that judge the tests and trials in a file. *)

val files : subject -> (string * string) list
(** Names and contents of its C files, including the table for hosts. *)

val interpreted : subject -> Recording.t -> string
(** The trace of the output as the interpreter computes it. Raises the same exceptions as a compiler
    bug does. *)

val recordings : Random.State.t -> rows:int -> subject -> Recording.t list
(** One tame and one wild recording. *)

val with_dt : Random.State.t -> rows:int -> tools -> subject -> Recording.t
(** A recording in which each step has an arbitrary dt, which hosts never pass. {!judge} uses it
    with [Tcc] only. *)

val fits : subject -> Recording.t -> bool
(** Whether the recording has the columns of the program's input. *)

val read_recording : subject -> string -> (Recording.t, string) result
(** Parses CSV. *)

val judge : tools -> c_engine list -> subject -> Recording.t list -> outcome
(** Runs all engines, and returns the first disagreement. *)
