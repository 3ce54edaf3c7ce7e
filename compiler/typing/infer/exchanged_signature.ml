open Basis

type kind =
  | Input_and_output  (** of a signal function, a task or a program *)
  | Elements
  | Parameters of int * int  (** their indices *)
  | Parameter_and_result

type t = { kind : kind; first : Resolve.Ir.ty; second : Resolve.Ir.ty; scheme : Resolve.Ir.scheme }

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
        | Tuple_type ts -> List.map (fun (a, b) -> (Elements, a, b)) (pairs ts)
        | _ -> []
      in
      ((Input_and_output, input, output) :: elements input) @ elements output
  | _ -> []

let most_candidates = 12

let candidates (written : Resolve.Ir.scheme) =
  let parameters, result = spine written.ty in
  let of_parameters =
    pairs (List.mapi (fun i p -> (i, p)) parameters)
    |> List.map (fun ((i, p), (j, q)) -> (Parameters (i, j), p, q))
  in
  let of_the_result =
    match (List.rev parameters, of_result result) with
    | last :: _, [] -> [ (Parameter_and_result, last, result) ]
    | _ -> []
  in
  of_result result @ of_parameters @ of_the_result
  |> List.filteri (fun i _ -> i < most_candidates)
  |> List.map (fun (kind, first, second) ->
         { kind; first; second; scheme = { written with ty = exchange first second written.ty } })

(* {1 The message} *)

(* The place of the type with the parentheses around it. *)
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

(* The place of the signature with the parenthesis before its context. *)
let with_opening sources (span : Span.t) =
  let column = Span.column span.start - 1 in
  if column < 1 then span
  else
    let start = Span.position ~line:(Span.line span.start) ~column in
    let before = Span.make ~file:span.file ~start ~stop:span.start in
    if Source.quote sources before = Some "(" then { span with start } else span

(* The two edits, and the text of the signature after them. *)
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

(* A formula with the wrong operator can fit the exchanged signature by coincidence, such as
   [derivative x] where [integral x] was meant: the definition is as likely to be wrong. *)
let is_about_the_result ~(written : Resolve.Ir.scheme) (d : Diagnostic.t) =
  String.equal d.code "E0320"
  && List.exists (fun (l : Diagnostic.label) -> Span.compare l.at written.span = 0) d.labels

let is_about_an_order (d : Diagnostic.t) = String.ends_with ~suffix:"in the wrong order" d.message

(* The left side with the two parameters exchanged. *)
let left_side sources ~name (b : Resolve.Ir.binding) i j =
  let texts = List.map (fun (p : Resolve.Ir.pattern) -> Source.quote sources p.span) b.parameters in
  match (List.nth_opt texts i, List.nth_opt texts j) with
  | Some (Some p), Some (Some q) when not (List.mem None texts) ->
      let moved k text = if k = i then q else if k = j then p else text in
      Some (String.concat " " (name :: List.mapi moved (List.filter_map Fun.id texts)))
  | _ -> None

(* The place in the definition that contradicts the signature. *)
let contradicting ~(written : Resolve.Ir.scheme) (d : Diagnostic.t) =
  match d.labels with
  | first :: _ when Span.compare (Span.merge d.at written.span) written.span = 0 -> first.at
  | _ -> d.at

let is_output (t : Resolve.Ir.ty) =
  match t.desc with Type_variable name -> String.starts_with ~prefix:"o" name | _ -> false

let explain sources ~name (b : Resolve.Ir.binding) ~written exchanged (told : Diagnostic.t list) =
  match (told, rewritten sources ~written exchanged) with
  | [ d ], _ when is_about_an_order d -> None
  (* otherwise, the context is wrong *)
  | { code = "E0309"; _ } :: _, _ when not (is_output exchanged.first) -> None
  | [ d ], Some (edits, text) when is_about_the_result ~written d ->
      let is_of_a_signature text =
        String.starts_with ~prefix:"if this is the right result, write the signature as" text
      in
      let signature = Printf.sprintf "%s :: %s" name text in
      if d.hints <> [] && not (List.exists is_of_a_signature d.hints) then None
      else
        Some
          ({ d with hints = List.filter (fun h -> not (is_of_a_signature h)) d.hints }
          |> Diagnostic.hint
               (Printf.sprintf
                  "if the types of the signature are in the wrong order, write it as `%s`" signature)
          |> Diagnostic.fix (Printf.sprintf "write `%s`" signature) edits)
  | d :: _, Some (edits, text) ->
      let here, others =
        match exchanged.kind with
        | Input_and_output -> ("the first type is the input, the second the output", None)
        | Elements -> ("the definition fits the other order", None)
        | Parameters (i, j) -> ("the definition fits the other order", left_side sources ~name b i j)
        | Parameter_and_result -> ("the type after the last `->` is the result", None)
      in
      let signature = Printf.sprintf "%s :: %s" name text in
      Some
        (Diagnostic.error ~code:d.code
           ~at:(Span.merge exchanged.first.span exchanged.second.span)
           "the types in the signature of `%s` are in the wrong order" name
        |> Diagnostic.here here
        |> Diagnostic.label ~at:(contradicting ~written d) "this does not fit the signature"
        |> Diagnostic.hint
             (Printf.sprintf "write the signature as `%s`%s" signature
                (Option.fold others ~none:""
                   ~some:(Printf.sprintf ", or begin the definition with `%s =`")))
        |> Diagnostic.fix (Printf.sprintf "write `%s`" signature) edits)
  | _ -> None
