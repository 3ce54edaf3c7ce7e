open Basis
open Typing
open Instance_fact

let owner words missing = Wording.owner words missing.variable
let constraint_ words (m : promise) = Wording.constraint_ words m.class_ m.of_

(* The corrected context, if the context lists all the needed classes but applies them to the wrong
   variables. *)
let of_other_variables needed promised =
  let class_of text = List.hd (String.split_on_char ' ' (String.trim text)) in
  let promised = List.map String.trim (String.split_on_char ',' promised) in
  let is_promised need =
    List.exists (fun p -> String.equal (class_of p) (class_of need)) promised
  in
  if not (List.for_all is_promised needed) then None
  else
    let meant p =
      let same need = String.equal (class_of need) (class_of p) in
      Option.value (List.find_opt same needed) ~default:p
    in
    Some (String.concat ", " (List.map meant promised))

let name by = Option.fold by ~none:"the signature" ~some:Signature_mistake.construct

(* The hint that adds the missing classes to the signature's context. *)
let promised words ~by (place : Span.t) needed d =
  let joined = String.concat ", " needed in
  let alone = match needed with [ _ ] -> joined | _ -> "(" ^ joined ^ ")" in
  let at i =
    Span.make ~file:place.file ~start:(Span.forward i place.start)
      ~stop:(Span.forward i place.start)
  in
  let insert whole edits =
    Diagnostic.hint "write `%s`" whole d |> Diagnostic.fix (Printf.sprintf "write `%s`" whole) edits
  in
  (* The span of an instance covers only its head, not its context. *)
  let is_whole =
    match (by : Surroundings.construct option) with
    | Some (Class _ | Instance _) -> false
    | Some (Signature _) | None -> true
  in
  match Wording.quote words place with
  | Some text
    when is_whole && String.length text > 0 && Span.line place.start = Span.line place.stop -> (
      let arrow = List.exists (String.equal "=>") (String.split_on_char ' ' text) in
      match (arrow, text.[0]) with
      | false, _ -> insert (alone ^ " => " ^ text) [ (at 0, alone ^ " => ") ]
      | true, '(' ->
          let rest = String.sub text 1 (String.length text - 1) in
          insert ("(" ^ joined ^ ", " ^ rest) [ (at 1, joined ^ ", ") ]
      | true, _ -> (
          match String.index_opt text '=' with
          (* a context in parentheses; the span starts inside them *)
          | Some i when String.contains (String.sub text 0 i) ')' -> (
              let close = String.rindex_from text i ')' in
              let rest = String.sub text close (String.length text - close) in
              match of_other_variables needed (String.sub text 0 close) with
              | Some promised ->
                  let whole =
                    Span.make ~file:place.file ~start:place.start
                      ~stop:(Span.forward close place.start)
                  in
                  insert ("(" ^ promised ^ rest) [ (whole, promised) ]
              | None -> insert ("(" ^ joined ^ ", " ^ text) [ (at 0, joined ^ ", ") ])
          | Some i ->
              let before = String.trim (String.sub text 0 i) in
              let rest = String.sub text i (String.length text - i) in
              insert
                (Printf.sprintf "(%s, %s) %s" before joined rest)
                [ (at 0, "("); (at (String.length before), ", " ^ joined ^ ")") ]
          | None -> d))
  | _ ->
      Diagnostic.hint
        "start %s with `%s =>`, or add the constraint to the existing context: `(…, %s) =>`"
        (name by) alone joined d

(* `smaller :: float -> float`, where the variable was meant as a type *)
let meant_as_a_type (m : promise) d =
  Option.map
    (fun type_ ->
      Diagnostic.hint
        "`%s` is a type variable, because it starts with a lower-case letter: for the type, write \
         `%s`"
        m.variable.name type_ d)
    (Variable_name.type_meant m.variable.name)

let one words ({ required; _ } as m : promise) =
  let needed = constraint_ words m in
  let error by =
    Diagnostic.error ~code:"E0309" ~at:required.at "%s needs `%s`, which %s does not declare"
      (Required_label.user words required)
      needed (name by)
  in
  match owner words m with
  | None -> error None
  | Some { by; place } -> (
      let by = Some by in
      error by
      |> (if Span.compare place required.at = 0 then Fun.id
          else Diagnostic.label ~at:place "%s" (name by))
      |> Required_label.add words required
      |> fun d ->
      match meant_as_a_type m d with Some d -> d | None -> promised words ~by place [ needed ] d)

let several words (first : promise) rest =
  let all = first :: rest in
  let needed = List.map (constraint_ words) all in
  let in_words = Enumeration.all (List.map (Printf.sprintf "`%s`") needed) in
  let by, place =
    match owner words first with
    | None -> (None, first.required.at)
    | Some { by; place } -> (Some by, place)
  in
  let label diagnostic (m : promise) =
    Diagnostic.label ~at:m.required.at "%s needs `%s`"
      (Required_label.user words m.required)
      (constraint_ words m) diagnostic
  in
  let d =
    List.fold_left label
      (Diagnostic.error ~code:"E0309" ~at:place "%s does not declare %s" (name by) in_words)
      all
  in
  match List.find_map (fun m -> meant_as_a_type m d) all with
  | Some d -> d
  | None -> promised words ~by place needed d

let unpromised words first = function [] -> one words first | rest -> several words first rest
