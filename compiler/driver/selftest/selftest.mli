(** [frobc selftest]: whether a C compiler, called as the user calls it, makes of generated C what
    it means.

    Programs that together have every construct of generated C are compiled by this very [frobc],
    run by the reference interpreter on {!Sample_input}, and by the C compiler; the outputs must be
    equal, bit for bit. Nothing is stored that could be out of date. *)

type compiler = {
  cc : string option;  (** the command, with or without options; that of [CC] or [cc] if [None] *)
  cflags : string option;  (** instead of {!Toolchain.flags} *)
  runner : string option;  (** a command that runs what was compiled, as an emulator *)
  real : Basis.Real.t;  (** the precision of the programs *)
}

val run : compiler -> int
(** Prints a line for each group and the verdict, and what is wrong to standard error. The exit
    status is {!Exit_status.ok}; {!Exit_status.rejected} if the compiler does not compile what it
    should, has other arithmetic, or makes something else of it; {!Exit_status.wrong_use} if it
    cannot be tried. *)

val programs : (string * string) list
(** File and entry of each program that is compiled, for the test that they have every construct. *)
