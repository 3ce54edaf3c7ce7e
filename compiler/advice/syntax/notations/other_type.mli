(** Frob equivalents of types in C++, Java and Python notation. *)

val known : string -> string option
(** The Frob type for this name, which may come from another language ([Float] for [double]) or
    differ only in case ([Distance] for [distance]). *)

val is_of_elements : string -> bool
(** Is this the name of an array or list type, such as [vector]? *)

val in_angles : string -> int -> (string * int) option
(** [Array 4 Float] for [Array<Float, 4>] or [std::array<float, 4>] at this offset, and the offset
    after it. *)

val of_text : string -> string option
(** The whole type in Frob: [Array n Float -> Bool] for [List[float] -> bool]. A type that is
    already in Frob keeps its meaning. [None] if the text contains anything unknown. *)

val signature : string -> int -> string option
(** The signature on the line that contains this offset, in Frob: [f :: Array n Float -> Bool] for
    [f : List[float] -> bool]. [None] if the line is not a whole signature. *)

val of_signature : string -> int -> string option
(** The result of {!signature}, written for a hint: in backticks, with advice on the size of an
    array. *)

val changed : string -> int -> string option
(** The result of {!of_signature}, or [None] if the signature is already in Frob. *)

val mentions : string -> string -> bool
(** Does the second text contain the first? *)
