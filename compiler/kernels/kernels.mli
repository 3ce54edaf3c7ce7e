(** The runtime's kernels of vision ([runtime/vision]), called by their names.

    They are C, for both engines the same: what the interpreter judges of a program with images is
    all that the compiler made, not the kernels themselves. Programs may call them without a file of
    their own. *)

val is_known : string -> bool
(** Is there a kernel of this name? *)

type image
(** What a camera saw, in memory to the end of the process. *)

type argument = Image of image | Struct of Bytes.t  (** as C has it *)

val call : string -> argument list -> size:int -> Bytes.t
(** Of a known one. [size]: of its result. *)

type frames
(** Those of a recording, in the folder beside it. *)

val frames : record:string -> frames
(** By the recording's file. Nothing is read yet. *)

val frame : frames -> number:int -> size:int64 -> hash:int64 -> (image, string) result
(** As a cell names it; else what was expected there. *)

val name : image -> int * int64 * int64
(** Its number, size and hash. *)
