open Basis

type t = {
  kind : Signature_fact.kind;
  first : Resolve.Ir.ty;
  second : Resolve.Ir.ty;
  scheme : Resolve.Ir.scheme;
}

let scheme exchanged = exchanged.scheme

(* {1 The exchanges} *)

let rec pairs = function [] -> [] | x :: rest -> List.map (fun y -> (x, y)) rest @ pairs rest

(* The type with the parts at these two places exchanged. *)
let rec exchange (a : Resolve.Ir.ty) (b : Resolve.Ir.ty) (t : Resolve.Ir.ty) : Resolve.Ir.ty =
  if t == a then b
  else if t == b then a
  else
    let within = exchange a b in
    let desc : Resolve.Ir.ty_desc =
      match t.desc with
      | Named n -> Named { n with arguments = List.map within n.arguments }
      | Function (p, r) -> Function (within p, within r)
      | Tuple_type ts -> Tuple_type (List.map within ts)
      | (Type_variable _ | Representation _ | Size _) as desc -> desc
    in
    { t with desc }

let rec spine (t : Resolve.Ir.ty) =
  match t.desc with
  | Function (p, r) ->
      let parameters, result = spine r in
      (p :: parameters, result)
  | _ -> ([], t)

let has_input_and_output (tycon : Ir.Global.t) =
  String.equal tycon.module_ "Prelude" && List.mem tycon.name [ "SF"; "Task"; "Program" ]

let of_result (t : Resolve.Ir.ty) =
  match t.desc with
  | Named { tycon; arguments = input :: output :: _; _ } when has_input_and_output tycon ->
      let elements (t : Resolve.Ir.ty) =
        match t.desc with
        | Tuple_type ts -> List.map (fun (a, b) -> (Signature_fact.Elements, a, b)) (pairs ts)
        | _ -> []
      in
      ((Signature_fact.Input_and_output, input, output) :: elements input) @ elements output
  | _ -> []

let most_candidates = 12

let candidates (written : Resolve.Ir.scheme) =
  let parameters, result = spine written.ty in
  let of_parameters =
    pairs (List.mapi (fun i p -> (i, p)) parameters)
    |> List.map (fun ((i, p), (j, q)) -> (Signature_fact.Parameters (i, j), p, q))
  in
  let of_the_result =
    match (List.rev parameters, of_result result) with
    | last :: _, [] -> [ (Signature_fact.Parameter_and_result, last, result) ]
    | _ -> []
  in
  of_result result @ of_parameters @ of_the_result
  |> List.filteri (fun i _ -> i < most_candidates)
  |> List.map (fun (kind, first, second) ->
         { kind; first; second; scheme = { written with ty = exchange first second written.ty } })

(* {1 The corrected signature} *)

(* The place of the type, including any parentheses around it. *)
let rec with_parentheses sources (span : Span.t) =
  let column = Span.column span.start in
  let wider =
    if column <= 1 then span
    else
      Span.make ~file:span.file
        ~start:(Span.position ~line:(Span.line span.start) ~column:(column - 1))
        ~stop:(Span.forward 1 span.stop)
  in
  match Source.quote sources wider with
  | Some text
    when Span.compare wider span <> 0
         && String.starts_with ~prefix:"(" text
         && String.ends_with ~suffix:")" text ->
      with_parentheses sources wider
  | Some _ | None -> span

(* The place of the signature, including the parenthesis before its context. *)
let with_opening sources (span : Span.t) =
  let column = Span.column span.start - 1 in
  if column < 1 then span
  else
    let start = Span.position ~line:(Span.line span.start) ~column in
    let before = Span.make ~file:span.file ~start ~stop:span.start in
    if Source.quote sources before = Some "(" then { span with start } else span

(* The two edits, and the text of the signature that results from them. *)
let rewritten sources ~(written : Resolve.Ir.scheme) exchanged =
  let first = with_parentheses sources exchanged.first.span in
  let second = with_parentheses sources exchanged.second.span in
  let quote = Source.quote sources in
  let whole = with_opening sources written.span in
  match (quote first, quote second, quote whole) with
  | Some a, Some b, Some text when Span.line first.start = Span.line whole.start ->
      let index (p : Span.position) = Span.column p - Span.column whole.start in
      let part from until = String.sub text from (until - from) in
      let text =
        String.concat ""
          [
            part 0 (index first.start);
            b;
            part (index first.stop) (index second.start);
            a;
            part (index second.stop) (String.length text);
          ]
      in
      Some ([ (first, b); (second, a) ], text)
  | _ -> None

(* If the context is wrong, the user probably exchanged inputs and outputs rather than other
   types. *)
let is_likely exchanged = function
  | Fact.Instance { fact = Unpromised _; _ } -> (
      match exchanged.first.desc with
      | Type_variable name -> String.starts_with ~prefix:"o" name
      | _ -> false)
  | _ -> true

let fact sources ~name (binding : Resolve.Ir.binding) ~written exchanged ~mistake :
    Signature_fact.t option =
  match rewritten sources ~written exchanged with
  | Some (edits, text) when is_likely exchanged mistake ->
      let { kind; first; second; _ } = exchanged in
      Some { name; binding; written; kind; first; second; edits; text }
  | Some _ | None -> None
