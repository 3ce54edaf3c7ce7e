(** What the grammar's actions are made of: spans and small conversions. *)

open Basis

type location = Lexing.position * Lexing.position
(** [$loc] *)

val span : location -> Span.t
val name : location -> string -> Ir.name
val unqualified : Ir.name -> Ir.qualified

val variable : location -> Ir.name -> Ir.qualified
(** A name where a value stands; an operator's span takes its parentheses along. *)

val qualified : location -> string * string -> Ir.qualified
(** [M.x] in one token. *)

val field : location -> string -> Ir.name
(** The name in a [.field] token. *)

val tuple : Surface.term option list -> Surface.term_desc
(** Of its elements; without some of them it is a section. *)

val context : Ir.ty -> (Ir.qualified * Ir.ty) list
(** What stands before [=>], read as a type. *)

val class_ : (Ir.qualified * Ir.ty) list -> Ir.ty -> Ir.declaration list -> Ir.declaration_desc
(** A class of the context and the head before its [where]; the head was read as a type. *)

val instance : (Ir.qualified * Ir.ty) list -> Ir.ty -> Ir.declaration list -> Ir.declaration_desc
(** Likewise. *)

(** {1 Foreign code}

    [sf], [include] and [copyable] are words only after [foreign]. *)

val foreign_signal_function :
  word:Ir.name -> Ir.name -> Ir.qualified_type -> Ir.name -> Ir.declaration_desc

val foreign_type : Ir.name -> Ir.name -> word:Ir.name option -> Ir.declaration_desc
val foreign_include : word:Ir.name -> Ir.name -> Ir.declaration_desc

val whole : string -> int option
(** The value of a number written without a point; [None] if it is out of the range of [Int]. *)

val size : location -> string * bool -> int
(** A number, and whether it is decimal, as the size of an array. *)

val product : Surface.factor list -> Ir.unit_
(** A unit, its factors last one first (at least one). *)

val exponent : location -> negative:bool -> string -> over:string -> Ir.rational

val scaled_unit : name:Ir.name -> Surface.factor list -> Ir.declaration_desc
(** The right side of a [unit] declaration, its factors last one first. *)

val do_body : location -> Surface.statement list -> Ir.proc_body
(** Of a [proc]. *)

val task_body : location -> Surface.statement list -> Ir.expr_desc
(** Of tasks. *)

val declarations : Ir.declaration list -> Ir.declaration list
(** A block as it is; rejects several clauses of one function. *)

val where : location -> Ir.declaration list -> Ir.declaration list
(** What follows the word, of a definition or a branch: not nothing. *)
