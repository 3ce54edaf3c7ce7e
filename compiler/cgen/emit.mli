(** The C files of a program, as text. *)

type t = {
  header : string;  (** NAME.h *)
  source : string;  (** NAME.c *)
  host_table : string option;
      (** NAME_host.c, for hosts only; none of a program with a foreign type in
          its input or output, which no host knows *)
  foreign : foreign;
}

(** What the user's C adds to a build. *)
and foreign = {
  calls : string list;  (** what the program calls, as in [foreign] declarations *)
  folders : string list;  (** where the headers are that it includes *)
}

val program : Machine.Ir.program -> t
