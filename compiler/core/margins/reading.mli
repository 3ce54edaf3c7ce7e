(** Evaluates a proc's expressions symbolically, following the variables, functions and composed
    signal functions that they mention. *)

type t

exception Too_large
(** Raised if the expression is too large to be worth analysing. *)

val create : Ir.program -> t

type env
(** The meaning of the variables and types in an expression. *)

val of_proc : t -> Ir.proc -> env
(** The environment of the proc itself. This call starts a new analysis, for which {!added} collects
    equations. *)

type head = { env : env; expr : Ir.expr }

val head : t -> stop:(Ir.Global.t -> bool) -> env -> Ir.expr -> head
(** Evaluates the expression to weak head normal form: the result is a variable, call, component or
    payload only if evaluation cannot continue. [stop]: definitions that are not expanded.
    Parameters of the program are not expanded either. *)

val run : t -> env -> Ir.Local.t -> head option
(** The signal function whose instance defines the variable, if any, with its environment. *)

val input : t -> env -> Ir.Local.t -> head option
(** The input of that instance. *)

val enter : env -> Ir.proc -> input:head -> env
(** The environment inside a proc that runs on this input. The first argument is the environment of
    the proc expression. *)

val ty : env -> Ir.ty -> Ir.ty
(** Converts a type from this environment to that of the analysed proc. *)

val copy : t -> env -> Ir.expr -> Ir.expr
(** A copy of the expression that can be used in an equation of the analysed proc.
    @raise Too_large *)

val fresh : t -> string -> Basis.Span.t -> Ir.Local.t

val added : t -> Ir.equation list
(** The equations needed by the copies made since the last call: instances of signal functions in
    procs that were entered. *)
