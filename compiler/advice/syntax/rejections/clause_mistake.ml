open Basis
open Syntax
open Rejection

let invented = [ "x"; "y"; "z"; "w" ]

(* Is the clause on one line, with as many patterns as the first clause? Only then does the fix
   apply. *)
let is_simple ~like c =
  List.compare_lengths c.parameters like.parameters = 0
  && List.compare_lengths c.parameters invented <= 0
  && Span.line c.span.start = Span.line c.span.stop
  && match c.right with { body = Plain _; where = [] } -> true | _ -> false

let case_of c =
  let names = List.filteri (fun i _ -> i < List.length c.parameters) invented in
  let value = match names with [ one ] -> one | _ -> "(" ^ String.concat ", " names ^ ")" in
  Printf.sprintf "%s %s = case %s of" c.name.text (String.concat " " names) value

(* The edits that turn a clause into a branch. They replace the text around the patterns. *)
let edits ~first c =
  let gap (from : Span.t) (till : Span.t) text =
    (Span.make ~file:from.file ~start:from.stop ~stop:till.start, text)
  in
  let opening, closing = match c.parameters with [ _ ] -> ("", "") | _ -> ("(", ")") in
  let rec between (previous : Ir.pattern) = function
    | (p : Ir.pattern) :: rest -> gap previous.span p.span ", " :: between p rest
    | [] -> (
        match c.right.body with
        | Plain e -> [ gap previous.span e.span (closing ^ " -> ") ]
        | Guarded _ -> [])
  in
  match c.parameters with
  | [] -> []
  | p :: rest ->
      let head = Span.make ~file:c.span.file ~start:c.span.start ~stop:p.span.start in
      let indentation = String.make (Span.column c.span.start + 3) ' ' in
      let begins = if c == first then case_of c ^ "\n" ^ indentation else String.make 4 ' ' in
      (head, begins ^ opening) :: between p rest

let most_places = 10

let diagnostic (first : clause) (second : clause) more =
  let also d (c : clause) = Diagnostic.label ~at:c.name.span "one more" d in
  let shown, besides = Long_list.split_at (most_places - 2) more in
  let all = first :: second :: more in
  Diagnostic.error ~code:"E0115" ~at:second.name.span "`%s` is defined by several clauses"
    first.name.text
  |> Diagnostic.label ~at:first.name.span "the first"
  |> (fun d -> List.fold_left also d shown)
  |> (if besides = [] then Fun.id
      else Diagnostic.note "there are %d more clauses" (List.length besides))
  |> Diagnostic.hint
       "write one clause, `%s`; on the lines below it, write a branch `pattern -> value` for each \
        clause"
       (case_of first)
  |>
  if List.for_all (is_simple ~like:first) all then
    Diagnostic.fix "write one clause with a `case`" (List.concat_map (edits ~first) all)
  else Fun.id
