(** Expressions of a proc, read through what they mention: variables, functions, and signal
    functions that are made of others. *)

type t

exception Too_large
(** So much has to be read that nothing would be gained. *)

val create : Ir.program -> t

type env
(** What the variables and the types mean in an expression. *)

val of_proc : t -> Ir.proc -> env
(** In the proc itself. What is read in it from here on may come to need more equations. *)

type head = { env : env; expr : Ir.expr }

val head : t -> stop:(Ir.Global.t -> bool) -> env -> Ir.expr -> head
(** What the expression comes to, as far as its outermost construct: no variable, no call of a
    function, no binding and no part that is known. [stop]: definitions that are not looked into, as
    parameters are not. *)

val run : t -> env -> Ir.Local.t -> head option
(** The signal function that the variable is an instance of, and where that is to be read. *)

val input : t -> env -> Ir.Local.t -> head option
(** And the input of that instance. *)

val enter : env -> Ir.proc -> input:head -> env
(** Inside a proc that runs in that place, on that input. *)

val ty : env -> Ir.ty -> Ir.ty
(** Of what is read there, in the types of the proc. *)

val copy : t -> env -> Ir.expr -> Ir.expr
(** The same, for an equation of the proc. Raises {!Too_large}. *)

val fresh : t -> string -> Basis.Span.t -> Ir.Local.t

val added : t -> Ir.equation list
(** The equations that copies have needed since this was asked last: instances of signal functions
    that run in procs that were entered. *)
