(** [frobc selftest]: checks that a C compiler, with the user's command and flags, compiles
    generated C correctly.

    The test programs together cover every construct of generated C. [frobc] compiles them to C, and
    the user's compiler compiles that C. The reference interpreter and the compiled programs then
    run on {!Sample_input}. Their outputs must be equal bit for bit. No expected output is stored,
    so it cannot become outdated. *)

type compiler = {
  cc : string option;  (** the command, with or without options; [None] means [CC], or [cc] *)
  cflags : string option;  (** replaces {!Toolchain.flags} *)
  runner : string option;  (** a command that runs the compiled programs, such as an emulator *)
  real : Basis.Real.t;  (** the precision with which the programs are compiled *)
}

val run : compiler -> int
(** Prints a line for each group and the verdict to standard output, and failures to standard error.
    The exit status is {!Exit_status.ok}; {!Exit_status.rejected} if the compiler rejects valid C,
    has different arithmetic, or generates incorrect code; {!Exit_status.wrong_use} if it cannot be
    tested. *)

val programs : (string * string) list
(** The file and the entry of each program. A test checks that they cover every construct. *)
