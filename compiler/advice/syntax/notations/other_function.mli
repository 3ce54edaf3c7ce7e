(** Mathematical functions of Python, numpy, C++ and MATLAB, and their equivalents in Frob. *)

val without_module : string -> string option
(** [cos] for [math.cos], [norm] for [np.linalg.norm] and [max] for [std::max]: the name without the
    module of another language whose functions are built in. *)

val constant : string -> string option
(** The constant of such a module in Frob, such as [pi] for [math.pi]. *)

val applied : string -> string list -> string option
(** The application of a function of such a module to these arguments, each already in Frob: [cos a]
    for [math.cos(a)], [a / 1[deg]] for [math.degrees(a)]. [None] if Frob has no such function, or
    not with this number of arguments. *)

val new_array : string -> string list -> string option
(** The array that such a function with these arguments creates: [[0, 0, 0]] for [zeros(3)]. *)

val range : string list -> (int * int) option
(** The first and the last number of [range(1, 20)], given its arguments. *)

val alone : string -> string option
(** The function without arguments: [abs] for [math.fabs]. *)

val import : string -> string option
(** The library module that the application returned by {!applied} needs. *)
