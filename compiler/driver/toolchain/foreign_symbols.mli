(** Where the C comes from that a program calls. A program that somebody else wrote must not reach
    what the C library can do: [system], [remove]. *)

val check :
  calls:string list ->
  sources:string list ->
  header:string ->
  folders:string list ->
  (unit, string) result
(** Whether each of these names is one of {!Basis.C_names.pure}, a kernel of the runtime
    ({!Kernels}), or is mentioned in one of the user's C files [sources], or of the headers that
    they or the text [header] include from [folders]. The error tells which is not. *)

val mentions : string -> string -> bool
(** [mentions text name]: whether the name is in the text, as a word of its own. *)

val giving : calls:string list -> string list -> string list
(** Of C files those that mention one of these names, other than the pure ones and kernels. *)
