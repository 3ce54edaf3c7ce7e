(** Syntax: the parse tree of a module.

    Invariants (see {!Lint}): Spans nest. Binary operators are grouped according to the fixed table
    in section 11 of the language reference. There are no layout tokens. Names are plain text.
    Patterns were parsed as expressions and then converted. *)

open Basis

type name = { text : string; span : Span.t }

type qualified = { qualifier : name option; name : name; span : Span.t }
(** A possibly qualified name, such as [M.x]. The text of an operator is its symbol, as in ["+"]. *)

type program = {
  file : string;
  header : header option;
  imports : import list;
  declarations : declaration list;
}

and header = { module_name : name; exports : name list option; span : Span.t }

and import = {
  module_ : name;
  qualified : bool;
  alias : name option;
  items : name list option;
  span : Span.t;
}

and declaration = { desc : declaration_desc; doc : string option; span : Span.t }
(** [doc]: the text of the [-- |] comment before the declaration. *)

and declaration_desc =
  | Signature of signature
  | Binding of binding
  | Type_alias of { name : name; parameters : type_parameters; body : ty }
  | Data of { name : name; parameters : type_parameters; constructors : constructor list }
  | Base_unit of name  (** [unit tick] *)
  | Scaled_unit of { name : name; scale : scale; unit_ : unit_ }
      (** [unit inch = 0.0254 m]; the scale is optional: [unit N = kg m/s^2] *)
  | Class of {
      superclasses : qualified list;
      name : name;
      variable : name;
      members : declaration list;  (** [Signature] and [Binding]: the methods and their defaults *)
    }  (** [class (Eq a) => Shape a where …] *)
  | Instance of instance
  | Primitive of signature  (** [primitive sin :: Float -> Float], only in the standard library *)
  | Foreign of foreign
  | Parameter of { name : name; ty : qualified_type; value : expr }
      (** [param kTurn :: Float[1/m] = 4[1/m]], with its default value *)
  | Claim of { kind : claim; label : name; condition : expr }
      (** [assert "keeps off" (d > 0.1[m])], among definitions *)
  | Check of { kind : check; label : name; value : expr }
      (** [test "limits" = during 2[s] observer], only at the top level *)

and claim = Assert | Assume
and check = Test | Trial

(** C names and paths are stored with their spans. *)
and foreign =
  | Foreign_value of { kind : foreign_kind; name : name; ty : qualified_type; symbol : name }
      (** [foreign cubeRoot :: Float -> Float = "cbrt"]; [foreign sf tracker :: … = "blob"] *)
  | Foreign_type of { name : name; c_type : name; copyable : bool }
      (** [foreign type Frame = "struct frame" copyable] *)
  | Foreign_include of name  (** [foreign include "blob.h"] *)

and foreign_kind = Foreign_function | Foreign_signal_function

and scale = {
  factor : string;  (** decimal text; ["1"] if omitted *)
  times_pi : bool;
      (** [unit deg = pi/180] has [factor = "1"], [divided_by = "180"] and [times_pi = true] *)
  divided_by : string;  (** decimal text; ["1"] if omitted *)
}

and instance = {
  context : (qualified * ty) list;
  class_ : qualified;
  head : ty;
  members : declaration list;  (** [Signature] and [Binding] *)
}
(** [instance Shape a => Shape (Maybe a) where …] *)

and signature = { names : name list; ty : qualified_type }

and qualified_type = { context : (qualified * ty) list; ty : ty }
(** [(Eq a, Ord b) => ty] *)

and type_parameters = { units : name list; types : name list }
and constructor = { name : name; fields : fields; span : Span.t; doc : string option }
and fields = Positional of ty list | Named of (name * ty) list

(** {1 Bindings} *)

and binding = { left : left; right : right; span : Span.t }

and left =
  | Name of name  (** [x = …] *)
  | Function_name of { name : name; parameters : pattern list }  (** at least one parameter *)
  | Pattern of pattern  (** [(x, y) = …]: tuples, records, [_] *)

and right = { body : body; where : declaration list }
(** [where] contains only [Signature], [Binding] and [Claim]. *)

and body = Plain of expr | Guarded of (expr * expr) list  (** [| guard = expr]; at least one *)

(** {1 Expressions} *)

and expr = { desc : expr_desc; span : Span.t }

and expr_desc =
  | Variable of qualified
  | Constructor of qualified
  | Number of number
  | String of string
  | Tuple of expr list  (** empty for [()], otherwise at least two elements *)
  | Tuple_section of expr option list  (** [(, x)]; at least one element is missing *)
  | Array of expr list  (** [[a, b]]; typing reports an empty array *)
  | Apply of expr * expr  (** juxtaposition, or [f $ x] *)
  | Binary of { operator : qualified; left : expr; right : expr }  (** including [a `f` b] *)
  | Negate of expr
  | Left_section of { left : expr; operator : qualified }  (** [(x +)] *)
  | Right_section of { operator : qualified; right : expr }  (** [(+ x)] *)
  | Power of { base : expr; exponent : int }  (** [e ^ k] *)
  | If of { condition : expr; then_ : expr; else_ : expr }
  | Case of { scrutinee : expr; branches : branch list }
  | Let of { bindings : declaration list; body : expr }
  | Lambda of { parameters : pattern list; body : expr }
  | Lambda_case of branch list  (** [\case …] *)
  | Proc of { input : pattern; body : proc_body }
  | Sequence of { statements : task_statement list; result : expr }
      (** a task: [do …] that is not the body of a [proc] *)
  | Record of { constructor : qualified; fields : (name * expr) list }
  | Update of { record : expr; fields : (name * expr) list }
  | Field of { record : expr; field : name }
  | Annotated of { expr : expr; ty : qualified_type }
  | Parenthesized of expr  (** kept for messages and printing *)

and number = {
  digits : string;  (** the literal's text, without the unit and the sign *)
  decimal : bool;  (** whether the literal has a decimal point or an exponent *)
  unit_ : unit_ option;
}

and branch = { pattern : pattern; body : branch_body; where : declaration list; span : Span.t }
and branch_body = Always of expr | If_guards of (expr * expr) list  (** [| guard -> expr] *)

and proc_body =
  | Output of { output : expr; equations : declaration list }  (** [proc p -> e where …] *)
  | Command of command  (** [proc p -> sf -< e] *)
  | Do of { statements : statement list; result : command }

and command = { signal_function : expr; argument : expr; span : Span.t }

and statement =
  | Bind of { pattern : pattern; command : command }  (** [p <- sf -< e] *)
  | Bind_expr of { pattern : pattern; expr : expr; span : Span.t }  (** [p <- e] *)
  | Let_equations of declaration list

and task_statement =
  | Task of { pattern : pattern option; task : expr; span : Span.t }  (** [p <- e], or [e] *)
  | Let_values of declaration list

(** {1 Patterns} *)

and pattern = { desc : pattern_desc; span : Span.t }

and pattern_desc =
  | Any
  | Bound of name
  | As of name * pattern
  | Tuple_of of pattern list  (** empty for [()], otherwise at least two elements *)
  | Array_of of pattern list  (** at least one element *)
  | Constructed of qualified * pattern list
  | Record_of of qualified * (name * pattern) list
  | Literal of { negative : bool; number : number }

(** {1 Types and units} *)

and ty = { desc : ty_desc; span : Span.t }

and ty_desc =
  | Type_variable of name
  | Type of { name : qualified; units : unit_ list option; arguments : ty list }
      (** [Scan[m] Bool]; [Float[u]]; [Float] *)
  | Representation of { name : name; unit_ : unit_ }  (** [n[u]] *)
  | Function of ty * ty
  | Tuple_type of ty list
  | Size of int  (** an array size, which is not negative *)
  | Size_operation of { operator : size_operator; left : ty; right : ty }
      (** arithmetic on sizes: [N - 1] *)

and size_operator = Plus_sizes | Minus_sizes | Times_sizes
and unit_ = { desc : unit_desc; span : Span.t }

and unit_desc =
  | One
  | Unit_name of name  (** a declared unit or a unit variable; resolution distinguishes them *)
  | Times of unit_ * unit_
  | Over of unit_ * unit_
  | To of unit_ * rational

and rational = { numerator : int; denominator : int }
(** In lowest terms, with a positive denominator. *)
