(** Each place in a module where a name stands, with what it is there. *)

open Syntax.Ir

type space = Value | Constructor | Type | Class | Unit | Field

type mention =
  | Declares of space * name * string option
      (** at the top of the module, or as a part of a declaration there; of a field its constructor
      *)
  | Binds of name  (** a variable or a definition inside another *)
  | Signs of { name : name; binder : name option }
      (** a signature, and the name that it is of; [None] where there is none beside it *)
  | Uses of { space : space; name : qualified; within : Basis.Span.t }
      (** [within]: the expression, pattern, type or constraint that begins with the name *)
  | Selects of { field : name; within : Basis.Span.t }  (** of a record there *)
  | Imports of { module_ : name; items : name list }
  | Exports of name
  | Local of { declaration : declaration; block : declaration list }
      (** a declaration inside another, with all that stand in its block *)

val of_program : program -> mention list
(** In no order. *)

val patterns : pattern -> name list
(** The variables in a pattern. *)
