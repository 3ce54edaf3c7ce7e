(** Helper functions for the grammar's semantic actions: spans and small conversions. *)

open Basis

type location = Lexing.position * Lexing.position
(** menhir's [$loc]: the start and end of a symbol *)

val span : location -> Span.t
val name : location -> string -> Ir.name
val unqualified : Ir.name -> Ir.qualified

val variable : location -> Ir.name -> Ir.qualified
(** A name used as a value. The span of an operator includes its parentheses. *)

val qualified : location -> string * string -> Ir.qualified
(** A qualified name [M.x], which is a single token. *)

val field : location -> string -> Ir.name
(** The name in a [.field] token. *)

val tuple : Surface.term option list -> Surface.term_desc
(** The tuple of these elements, or a tuple section if some are missing. *)

val context : Ir.ty -> (Ir.qualified * Ir.ty) list
(** Converts the context before [=>], which the grammar parses as a type. *)

val class_ : (Ir.qualified * Ir.ty) list -> Ir.ty -> Ir.declaration list -> Ir.declaration_desc
(** Builds a class from its context, its head and its members. The grammar parses the head as a
    type. *)

val instance : (Ir.qualified * Ir.ty) list -> Ir.ty -> Ir.declaration list -> Ir.declaration_desc
(** Like {!class_}, for an instance. *)

(** {1 Foreign code}

    [sf], [include] and [copyable] are keywords only after [foreign]. *)

val foreign_signal_function :
  word:Ir.name -> Ir.name -> Ir.qualified_type -> Ir.name -> Ir.declaration_desc

val foreign_type : Ir.name -> Ir.name -> word:Ir.name option -> Ir.declaration_desc
val foreign_include : word:Ir.name -> Ir.name -> Ir.declaration_desc

val whole : string -> int option
(** The value of a literal without a decimal point; [None] if it does not fit in an [Int]. *)

val size : location -> string * bool -> int
(** The size of an array, given the text of a literal and a flag that says whether the literal has a
    decimal point or an exponent. *)

val sign_of_sizes : location -> string -> Ir.size_operator
(** Converts an operator between two sizes; the grammar itself handles [-] and [*]. Rejects every
    operator except [+]. *)

val product : Surface.factor list -> Ir.unit_
(** The unit that is the product of these factors, in reverse order. There must be at least one. *)

val exponent : location -> negative:bool -> string -> over:string -> Ir.rational

val scaled_unit : name:Ir.name -> Surface.factor list -> Ir.declaration_desc
(** A [unit] declaration whose right-hand side has these factors, in reverse order. *)

val do_body : location -> Surface.statement list -> Ir.proc_body
(** The body of a [proc]. *)

val task_body : location -> Surface.statement list -> Ir.expr_desc
(** A [do] block of tasks. *)

val declarations : Ir.declaration list -> Ir.declaration list
(** Returns the declarations of a block unchanged. Rejects a function with several clauses. *)

val where : location -> Ir.declaration list -> Ir.declaration list
(** The declarations of a [where], in a definition or a branch. Rejects an empty [where]. *)
