(** C: the part of C99 that we emit, which is also C++17.

    Always true: names are C identifiers, different from each other where C asks for it; expressions
    have no side effects except through [Call]; every conversion that loses something is an explicit
    [Cast]. *)

type ty =
  | Void
  | Bool
  | Uint8
  | Int32
  | Int64
  | Real of Basis.Real.t
  | Struct of string
  | Named of string  (** as the user's C calls it: [struct frame], or a [typedef] *)
  | Members of member list  (** a struct without a name, inside another *)
  | Union of member list  (** likewise *)
  | Array of ty * int  (** only of a member *)
  | Pointer of ty
  | Pointer_to_const of ty

and member = { name : string; ty : ty; comment : string  (** or [""] *) }

type unary = Negate | Not | Address | Dereference

type binary =
  | Times
  | Over
  | Remainder
  | Plus
  | Minus
  | Less
  | Less_equal
  | Greater
  | Equal
  | Not_equal
  | And
  | Or

type expr =
  | Name of string
  | Boolean of bool
  | Integer of int32
  | Long of int64  (** not negative *)
  | Float of Basis.Real.t * float
  | Unary of unary * expr
  | Binary of binary * expr * expr
  | Conditional of expr * expr * expr
  | Call of string * expr list
  | Member of expr * string  (** [e.x] *)
  | Arrow of expr * string  (** [e->x] *)
  | Subscript of expr * expr
  | Aggregate of expr list  (** [{a, b}], only as an initial value *)
  | Cast of ty * expr

type statement = { desc : statement_desc; comment : string  (** or [""] *) }

and statement_desc =
  | Constant of { ty : ty; name : string; value : expr }
  | Table of { ty : ty; name : string; value : expr }  (** made of literals, once for all *)
  | Variables of { ty : ty; names : string list }  (** without values yet *)
  | Variable of { ty : ty; name : string; value : expr }
  | Initialize of { ty : ty; name : string; values : expr list }  (** a struct, member by member *)
  | Assign of expr * expr
  | Add_to of expr * expr  (** [a += b] *)
  | Do of expr
  | If of { condition : expr; then_ : statement list; else_ : statement list }
  | Switch of { value : expr; cases : (string * statement list) list }
      (** by constants, each once; the last one is the default *)
  | For of { index : string; count : int; body : statement list }  (** an Int32, from 0 *)
  | Repeat of { rounds : string; most : int; body : statement list }
      (** at least once, again at its end or a [Continue], but not more than so often: [rounds] is
          an Int32, declared before as 0 *)
  | Continue  (** of the [For] or [Repeat] around it: the next round, if there is one *)
  | Break  (** out of the [For] or [Repeat] around it; not in a [Switch] *)
  | Return of expr

type linkage = External | Static | Static_inline

type function_ = {
  linkage : linkage;
  result : ty;
  name : string;
  parameters : (ty * string) list;
  body : statement list;
  comment : string;  (** or [""] *)
}

type declaration =
  | Struct_definition of {
      name : string;
      overlaid : bool;
          (** its memory may have been that of another struct: compilers must not take accesses to
              the two for independent *)
      members : member list;
      comment : string;
    }
  | Constants of { names : string list; comment : string }  (** an enumeration, from 0 *)
  | Prototype of function_  (** without its body *)
  | Function of function_
  | Text of string  (** lines of C of our own: directives, comments *)

type file = declaration list
