open Basis

type decider = { place : Span.t; decides : Type.t; a_size : bool }
type number = { negative : bool; digits : string; unit_ : Resolve.Ir.unit_ option; at : Span.t }

type completed = {
  ty : Type.t;
  units : Units.t list;
  is_example : bool;
  fields : (Syntax.Ir.name * number option * Units.t option) list;
}

type reason =
  | Unknown
  | Signature of { name : string; at : Span.t }
  | Annotation of Span.t
  | Parameter of {
      callee : string option;
      head : Resolve.Ir.expr option;
      at : Span.t;
      position : int;
      decided_by : decider list;
      takes : int;
      given : Resolve.Ir.expr list;
      before : string option;
      of_local : Span.t option;
    }
  | Operand of { operator : string; other : Resolve.Ir.expr; other_type : Type.t }
  | Branch of Span.t
  | Condition
  | Element of Span.t
  | Value of Span.t
  | Pattern of Span.t
  | Statement of Span.t option
  | Last_statement of reason
  | Uses of { name : string; at : Span.t }
  | Field of {
      name : string;
      at : Span.t;
      constructor : Environment.constructor option;
      completed : completed Lazy.t option;
    }
  | Output of reason

type t = { ty : Type.t; because : reason }

let make because ty = { ty; because }
