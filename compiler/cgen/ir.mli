(** C: the subset of C99 that the compiler generates, which is also valid C++17.

    Invariants: names are C identifiers, and unique where C requires it; expressions have no side
    effects except through [Call]; every lossy conversion is an explicit [Cast]. *)

type ty =
  | Void
  | Bool
  | Uint8
  | Uint32
  | Int32
  | Int64
  | Real of Basis.Real.t
  | Struct of string
  | Named of string  (** a type that the user's C defines: [struct frame], or a [typedef] *)
  | Members of member list  (** an anonymous struct inside another one *)
  | Union of member list  (** an anonymous union *)
  | Array of ty * int  (** only for members *)
  | Pointer of ty
  | Pointer_to_const of ty

and member = { name : string; ty : ty; comment : string  (** [""] if none *) }

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

type statement = { desc : statement_desc; comment : string  (** [""] if none *) }

and statement_desc =
  | Constant of { ty : ty; name : string; value : expr }
  | Table of { ty : ty; name : string; value : expr }
      (** a static constant that consists of literals *)
  | Variables of { ty : ty; names : string list }  (** variables without initial values *)
  | Variable of { ty : ty; name : string; value : expr }
  | Initialize of { ty : ty; name : string; values : expr list }
      (** a struct with values for all its members *)
  | Assign of expr * expr
  | Add_to of expr * expr  (** [a += b] *)
  | Do of expr
  | If of { condition : expr; then_ : statement list; else_ : statement list }
  | Switch of { value : expr; cases : (string * statement list) list }
      (** each constant occurs once; the last case is the default *)
  | For of { index : string; count : int; body : statement list }
      (** the index is an Int32 that starts at 0 *)
  | Repeat of { rounds : string; most : int; body : statement list }
      (** a [do] loop: the end of the body, or a [Continue], starts the next iteration, up to [most]
          iterations in total. [rounds] is an Int32 variable that has been declared with the value 0
      *)
  | Continue
      (** continues the enclosing [For] or [Repeat] with the next iteration, if there is one *)
  | Break  (** leaves the enclosing [For] or [Repeat]; not allowed in a [Switch] *)
  | Return of expr

type linkage = External | Static | Static_inline

type function_ = {
  linkage : linkage;
  result : ty;
  name : string;
  parameters : (ty * string) list;
  body : statement list;
  comment : string;  (** [""] if none *)
}

type declaration =
  | Struct_definition of {
      name : string;
      overlaid : bool;
          (** its memory may overlap with another struct's, so compilers must not assume that
              accesses to the two structs are independent *)
      members : member list;
      comment : string;
    }
  | Constants of { names : string list; comment : string }  (** an enumeration that starts at 0 *)
  | Prototype of function_  (** the function without its body *)
  | Function of function_
  | Text of string  (** lines of C text: directives, comments *)

type file = declaration list
