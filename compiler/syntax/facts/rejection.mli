(** Input that is grammatical but has no meaning. *)

open Basis
open Ir

type clause = { name : name; parameters : pattern list; right : right; span : Span.t }
(** One clause of a function that is defined by several clauses. *)

type t =
  (* types and classes *)
  | Context_without_classes of Span.t
  | Class_head of Span.t
  | Superclass_of_other_type of { at : Span.t; class_ : name; variable : name }
  | Instance_head of Span.t
  | Foreign_word of { expected : string; found : name }
  | Size_not_whole of { at : Span.t; digits : string }
  | Size_operator of { at : Span.t; operator : string }
  (* units *)
  | Number_in_unit of { at : Span.t; digits : string }
  | Exponent_not_whole of { at : Span.t; digits : string }
  | Exponent_too_large of Span.t
  | Exponent_over_zero of Span.t
  | Scale_of_unit of Span.t
  (* the statements of a [proc] *)
  | Expression_in_proc of { expr : expr; is_last : bool }
  | Output_binds of { at : Span.t; name : string option  (** if it binds a single variable *) }
  | Output_is_let of { at : Span.t; name : string option  (** the name that it defines last *) }
  | Empty_proc of Span.t
  (* the statements of a task *)
  | Last_task_binds of {
      at : Span.t;
      name : string option;  (** the name, if it binds a single variable *)
    }
  | Last_task_is_let of Span.t
  | Empty_task of Span.t
  | Rec_in_task of Span.t
  (* definitions *)
  | Empty_where of Span.t
  | Several_clauses of { first : clause; second : clause; others : clause list }
  (* terms that are not expressions *)
  | Unit_after_space of {
      number : Surface.term;
      digits : string;
      unit_ : Surface.term list;
      at : Span.t;
    }  (** [at]: the brackets *)
  | Wildcard_in_expression of Span.t
  | As_in_expression of { at : Span.t; name : name }
  (* terms that are not patterns *)
  | Qualified_in_pattern of { at : Span.t; qualifier : name; name : name }
  | Operator_bound of { at : Span.t; operator : name }
  | Empty_array_in_pattern of Span.t
  | Application_in_pattern of Span.t  (** the place of the function *)
  | Braces_in_pattern of Span.t  (** the place of the code before the braces *)
  | Minus_in_pattern of Span.t
  | Expression_in_pattern of { at : Span.t; desc : expr_desc }
  (* terms that are not left-hand sides *)
  | Minus_in_name of { at : Span.t; left : name; right : name }
  | Operator_on_left of qualified
  | Parentheses_on_left of Span.t
  (* operators *)
  | Exponent of { base : Surface.term; operator : qualified; exponent : Surface.term }
  | Two_operators of {
      left : Surface.term;
      first : qualified;
      middle : Surface.term;
      second : qualified;
      right : Surface.term;
      compare : bool;  (** whether both operators are comparisons *)
    }
  | Minus_after of { operator : qualified; at : Span.t; operand : Surface.term }
  | Two_minuses of { first : Span.t; second : Span.t; operand : Surface.term }
  | Section of { operator : qualified; inner : qualified option  (** [None]: a minus sign *) }
