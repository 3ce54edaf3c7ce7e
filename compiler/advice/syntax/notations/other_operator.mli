(** Frob's equivalents of expressions that use operators from other languages. *)

val negation : string -> int -> (string * int) option
(** [not (f x)] for the application [f x] at this offset, which follows a [!] or a [~], and the
    offset after the application. [None] if there is no operand. *)

val pipeline : string -> int -> string option
(** [g (f x)] for [x |> f |> g], with a [|>] at this offset. *)
