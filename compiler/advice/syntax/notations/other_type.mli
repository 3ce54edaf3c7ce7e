(** Types in the notation of C++, Java and Python, in Frob. *)

val in_angles : string -> int -> (string * int) option
(** [Array 4 Float] for [Array<Float, 4>] or [std::array<float, 4>] at this offset, and the offset
    after it. *)
