open Basis
open Typing
open Diagnostic

type t = {
  words : Wording.t;
  subject : Resolve.Ir.expr option;
  at : Span.t;
  expected : Expected.t;
  found : Type.t;
  wanted : Type.t;
  given : Type.t;
}

type Diagnostic.topic += Call of string
type rule = t -> Diagnostic.t option

let make words ~subject ~at ~(expected : Expected.t) ~found =
  {
    words;
    subject;
    at;
    expected;
    found;
    wanted = Type.expand expected.ty;
    given = Type.expand found;
  }

let first rules fact = List.find_map (fun rule -> rule fact) rules

let other_operand fact =
  match fact.expected.because with
  | Operand { other; other_type; _ } when Type.repr other_type == Type.repr fact.expected.ty ->
      Some other
  | _ -> None

let is_statement fact =
  match fact.expected.because with Statement _ | Last_statement _ -> true | _ -> false

let is_a_parameter fact =
  match fact.expected.because with
  | Parameter { callee = Some name; _ } ->
      not (List.mem name [ "+"; "-"; "*"; "/"; "^+^"; "^-^"; "*^" ])
  | _ -> false

let callee fact =
  match fact.expected.because with Parameter { callee = Some f; _ } -> f | _ -> "f"

let name fact = Option.bind fact.subject Plain_name.of_expr
let expected_text fact = Wording.described fact.words fact.expected.ty
let found_text fact = Wording.described fact.words fact.found

let source fact =
  Option.bind fact.subject (fun (e : Resolve.Ir.expr) -> Wording.quote fact.words e.span)

let raw fact default = Option.value (source fact) ~default
let grouped fact none = Option.fold (source fact) ~none ~some:Source.grouped

let elements fact =
  match fact.subject with
  | Some { desc = Tuple es; _ } ->
      List.map (fun (e : Resolve.Ir.expr) -> Wording.quote fact.words e.span) es
  | _ -> [ None ]

let all texts = if List.mem None texts then None else Some (List.filter_map Fun.id texts)
let names n = List.init n (Variable_name.nth Variable_name.Type)

let different fact =
  error ~code:"E0301" ~at:fact.at "expected %s, found %s" (expected_text fact) (found_text fact)

let hinted ?topic fact format =
  Printf.ksprintf (fun text -> hint ?topic "%s" text (different fact)) format

let not_a_condition fact =
  error ~code:"E0301" ~at:fact.at "a condition must be `Bool`, but this is %s" (found_text fact)

let not_matched fact =
  error ~code:"E0301" ~at:fact.at "this pattern matches %s, but the value is %s" (found_text fact)
    (expected_text fact)
