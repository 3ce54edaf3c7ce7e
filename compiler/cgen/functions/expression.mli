(** Generates expressions of a C function. *)

type names
(** The names that a function uses for its variables and the state of its node. *)

val names : ?body:Step.Ir.statement list -> Program_names.t -> node:int -> names
(** [body]: the statements of the function; the default is none. *)

val scope : names -> Name.scope
val vocabulary : names -> Program_names.t

val index : names -> int -> string
(** The index variable of a loop at this nesting depth. *)

val read_as : names -> Step.Ir.variable -> Ir.expr -> unit
(** Records that this expression replaces all further reads of the variable. *)

val read_elements_as : names -> Step.Ir.variable -> (Ir.expr list -> Ir.expr) -> unit
(** Records how to read the array's elements: the function receives an index for each dimension. The
    array must not be read in any other way. *)

val element : names -> Step.Ir.expr -> Ir.expr -> Ir.expr
(** The element of an array at an index. *)

val variable : names -> Step.Ir.variable -> string
(** The name of a variable, chosen when it is first needed. *)

val field : names -> Step.Ir.field -> Ir.expr
(** The expression [self->x]. *)

val state : names -> Step.Ir.field -> Ir.expr
(** A pointer to the struct that contains the state of the field's node. The functions of that node
    expect this pointer as an argument. *)

val reaches_state : names -> bool
(** Whether any field of the state has been accessed. *)

val bounded : names -> Step.Ir.field -> Step.Ir.expr -> Ir.statement_desc option
(** The statement that writes a bounded time ({!Step.Short_times}); [None] for other fields. The
    state stores the time that is left until the bound. If {!Step.Short_times.reached} contains the
    time, the statement also declares a variable, which later comparisons with the bound use. *)

val unlimited : names -> Step.Ir.variable -> Step.Ir.expr -> Step.Ir.expr
(** The initial value in the declaration of a variable. For a variable that {!Limits} found, this is
    [x] instead of [max 0 x]. *)

val parameters : names -> Step.Ir.variable list -> (Ir.ty * string) list
(** The parameters of a node's function: arrays are passed by address. *)

val address : Ir.expr -> Ir.expr

val arguments : names -> Step.Ir.variable list -> Step.Ir.expr list -> Ir.expr list
(** The arguments for these parameters of a node's function. *)

val operand : names -> at:Basis.Span.t -> Step.Ir.expr -> Ir.expr
(** Like {!of_step}, but a number that has a name in the source keeps that name. [at]: the place of
    the operation that has this operand, or of the statement that has this value. *)

val of_step : names -> Step.Ir.expr -> Ir.expr
