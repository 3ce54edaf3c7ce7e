(** The equation that closes a loop, rewritten so that it reads an earlier value. *)

type kind =
  | Integral  (** [x = x + v * 0.02[s]], where an integral is meant *)
  | Previous  (** any other equation: it reads the previous value *)

type t = {
  kind : kind;
  before : (string * string) option;  (** an equation to add: its name and right-hand side *)
  right : string;  (** the new right-hand side *)
  edits : (Span.t * string) list;
}

val of_line : string -> (string * string * int) option
(** The equation [name = …] on this line, which may also contain a closing bracket and a comment:
    the name, the right-hand side, and the index at which the right-hand side begins. *)

val integral : name:string -> string -> string option
(** [integral v] for the right-hand side [x + v * 0.02[s]] or [v * dt + x] of the equation for [x],
    which is the [name]. *)

val fix : Source.t -> name:string -> at:Span.t -> read:string -> start:string -> t option
(** The equation for [name], whose name is at [at], with [delay start read] in place of [read], or
    with an integral if it adds a product with a time step to its own value. If [read] occurs in a
    choice, the [delay] gets a separate equation, because a branch must not run it. [None] if the
    equation is not [name = …] on one line. *)
