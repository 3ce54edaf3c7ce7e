(** Lists each occurrence of a name in a module, with its role there. *)

open Syntax.Ir

type space = Value | Constructor | Type | Class | Unit | Field

type mention =
  | Declares of space * name * string option
      (** a top-level declaration or a part of one; for a field, with its constructor *)
  | Binds of name  (** a local variable or definition *)
  | Signs of { name : name; binder : name option }
      (** a name in a type signature, and the same name in its definition; [None] if the signature's
          block does not define the name *)
  | Uses of { space : space; name : qualified; within : Basis.Span.t }
      (** [within]: the expression, pattern, type or constraint that starts with the name *)
  | Selects of { field : name; within : Basis.Span.t }
      (** an access to a field of the record in [within] *)
  | Imports of { module_ : name; items : name list }
  | Exports of name
  | Local of { declaration : declaration; block : declaration list }
      (** a local declaration, with all declarations of its block *)

val of_program : program -> mention list
(** In unspecified order. *)

val patterns : pattern -> name list
(** The variables in a pattern. *)

type declared = (space * string * string option, Basis.Span.t) Hashtbl.t
(** Maps the namespace and name of each declaration to the place of the name. For a field, the third
    component of the key is its constructor. *)

val declared : mention list -> declared
