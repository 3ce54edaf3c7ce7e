(** Runs the C compiler of this machine on generated C. *)

val flags : string list
(** Flags that generated C requires: floating-point operations must not be contracted. *)

type foreign = {
  sources : string list;  (** the user's C and C++ files to compile or link, without headers *)
  folders : string list;  (** folders in which C compilers search for includes in quotes *)
  allowed : string list;  (** files that may be compiled, including headers; see {!Included.check} *)
}

type kind =
  | Shared_object  (** for a host that loads it dynamically *)
  | Executable  (** one of the inputs contains the host with its [main] *)

type machine = {
  compiler : string;  (** the program to call *)
  fix : string;  (** advice for the user if the program is not installed *)
  options : string list;  (** flags in addition to {!flags} *)
}

val this_machine : unit -> machine
(** The compiler that [CC] names, or else the first of [cc], [gcc] and [clang] that is installed, or
    else the compiler that comes with frobc (see {!Tcc}). *)

val build :
  ?machine:machine ->
  kind ->
  headers:string ->
  inputs:string list ->
  ?includes:string list ->
  foreign:foreign option ->
  name:string ->
  (string * string) list ->
  (string, string) result
(** [build kind ~headers ~inputs ~includes ~foreign ~name files] compiles the [.c] files among
    [files] (names and contents), and links them with the archives and sources [inputs]. [includes]
    are files that these sources may include. Uses the C compiler of this machine unless [machine]
    is given. Returns the path of the result. Results are stored in the {!Cache} under a digest of
    everything they depend on, so a program is compiled only once. However, a program that uses the
    user's files is always recompiled. The error is a message for the user. *)
