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
(** Returns [integral v] for the right-hand side [x + v * 0.02[s]] or [v * dt + x], where [x] is the
    name. *)

val fix : Source.t -> name:string -> at:Span.t -> read:string -> start:string -> t option
(** Rewrites the equation for [name], which begins at [at], so that it contains [delay start read]
    in place of [read]. If the equation adds the product of a rate and a time step to its own value,
    it becomes an integral. If it contains a branch or a function, the [delay] gets a separate
    equation, because it must not run inside a branch or a function. [None] if the equation is not
    [name = …] on one line. *)
