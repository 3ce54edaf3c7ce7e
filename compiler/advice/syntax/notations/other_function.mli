(** Mathematical functions of Python, numpy, C++ and MATLAB, and their equivalents in Frob. *)

val without_module : string -> string option
(** The name without its module: [cos] for [math.cos], [norm] for [np.linalg.norm] and [max] for
    [std::max]. [None] if the module's functions are not built into Frob. *)

val constant : string -> string option
(** The Frob equivalent of a constant of such a module: [pi] for [math.pi]. *)

val applied : string -> string list -> string option
(** The Frob equivalent of a call to a function of such a module, with these arguments, which are
    already in Frob: [cos a] for [math.cos(a)], [a / 1[deg]] for [math.degrees(a)]. [None] if Frob
    has no equivalent with this number of arguments. *)

val new_array : string -> string list -> string option
(** The array that such a function creates from these arguments: [[0, 0, 0]] for [zeros(3)]. *)

val range : string list -> (int * int) option
(** The first and the last number of [range(1, 20)], given its arguments. *)

val alone : string -> string option
(** The Frob name of such a function: [abs] for [math.fabs]. *)

val import : string -> string option
(** The library module that the result of {!applied} needs for this function. *)
