(** Mathematical functions of Python, numpy, C++ and MATLAB, and their equivalents in Frob. *)

val without_module : string -> string option
(** [cos] for [math.cos], [norm] for [np.linalg.norm] and [max] for [std::max]: the name without its
    module, if that is a module of another language whose functions are built into Frob. *)

val constant : string -> string option
(** The Frob equivalent of a constant of such a module: [pi] for [math.pi]. *)

val applied : string -> string list -> string option
(** The Frob equivalent of a call of such a module's function with these arguments, which are
    already in Frob: [cos a] for [math.cos(a)], [a / 1[deg]] for [math.degrees(a)]. [None] if Frob
    has no equivalent with this number of arguments. *)

val new_array : string -> string list -> string option
(** The array that such a function creates from these arguments: [[0, 0, 0]] for [zeros(3)]. *)

val range : string list -> (int * int) option
(** The first and the last number of [range(1, 20)], given its arguments. *)

val alone : string -> string option
(** The Frob equivalent of such a function without arguments: [abs] for [math.fabs]. *)

val import : string -> string option
(** The library module that the application returned by {!applied} needs. *)
