(** Child processes of frobc.

    When frobc ends, even if it is killed by SIGKILL, the kernel sends its children a signal that
    ends them, too. Only those started with [Outlives] may keep running. *)

type life =
  | Outlives
      (** for programs that may still have data to write, and that exit at the end of their input *)
  | Ends_with_us
  | Ends_with_all_it_started
      (** For programs that start others, such as compilers. The child has its own process group, so
          it must not read from the terminal. *)

val start :
  life ->
  string ->
  string list ->
  stdin:Unix.file_descr ->
  stdout:Unix.file_descr ->
  stderr:Unix.file_descr ->
  int
(** [start life program arguments] searches [PATH] for the program and returns its process id.
    Raises [Unix.Unix_error] if the program cannot be started. *)

val end_with_parent : unit -> unit
(** If the environment variable [FROBC_PARENT] is the id of the process that started frobc, asks the
    kernel to send SIGTERM to frobc when that process (or the thread that forked) has ended. The
    Python package sets this variable. *)

val allow_stack : int -> unit
(** Lets the stack of this process grow to this size in bytes, if the system allows that. Processes
    created by {!start} get the original limit. *)

val put_stack_back : unit -> unit
(** Undoes {!allow_stack}, for a process that replaces itself with another program. *)
