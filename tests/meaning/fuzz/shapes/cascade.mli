(** Switches of which several occur at one instant, in a program that is little else.

    In C a loop goes from mode to mode within an instant, no more often than the compiler has found
    that it can; and a mode of which it has found that it stays for its first instant is not asked
    whether it ends. Both rest on what is known of the numbers that modes hand on. So these modes
    ask about such numbers, and whether one is low or high is decided by the input. *)

val one_of_few : ?by:string -> Scope.t -> string
(** An Int of which an analysis of ranges can tell something; often one of two, chosen by a Bool: by
    this one, or by any. *)

val asked_of : Scope.t -> string -> string
(** Whether the Int is, say, less than another small one. *)

val bool : Scope.t -> string
(** That mostly depends on the input, if anything in scope does. *)

val definitions :
  Scope.t -> input:Type.t -> pattern:string * (string * Type.t) list -> string * string list
(** Modes of that input that lead to each other, and signal functions of it that give an Int, each
    of which starts in one of them: the text of all, and the names of the latter. *)
