open Basis
open Typing

(* A formula with the wrong operator can fit the exchanged signature by coincidence. For example,
   the user may have written [derivative x] instead of [integral x]. So the definition is just as
   likely to be wrong. *)
let is_about_the_result ~(written : Resolve.Ir.scheme) (d : Diagnostic.t) =
  String.equal d.code "E0320"
  && List.exists (fun (l : Diagnostic.label) -> Span.compare l.at written.span = 0) d.labels

(* Is this a message about swapped arguments, parameters or components? Such a message explains the
   mistake better. *)
let is_about_an_order (mistake : Fact.t) =
  match mistake with
  | Misapplied { call = { exchanged = Some _; _ } | { rotated = Some _; _ }; _ }
  | Inference { fact = Exchanged_pair _ | Parameters_in_other_order _; _ } ->
      true
  | Inference { around; fact = Mismatch { expected; found; clash = Different_units _; _ } } ->
      Setting_order.wrong (Wording.of_surroundings around) ~expected ~found <> None
  | _ -> false

(* `sign :: Float -> Int` with a result of `0.5`: the number is the likely mistake. *)
let is_of_a_decimal (kind : Signature_fact.kind) (mistake : Fact.t) =
  match (kind, mistake) with
  | ( Parameter_and_result,
      Inference
        {
          fact =
            Mismatch { subject = Some { desc = Number { decimal = true; unit_ = None; _ }; _ }; _ };
          _;
        } ) ->
      true
  | _ -> false

(* The left-hand side with the two parameters swapped. *)
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

let in_wrong_order sources
    ({ name; binding; written; kind; first; second; edits; text } : Signature_fact.t)
    (d : Diagnostic.t) =
  let here, others =
    match kind with
    | Input_and_output -> ("the first type is the input, and the second is the output", None)
    | Elements -> ("the definition matches the other order", None)
    | Parameters (i, j) ->
        ("the definition matches the other order", left_side sources ~name binding i j)
    | Parameter_and_result -> ("the type after the last `->` is the result", None)
  in
  let signature = Printf.sprintf "%s :: %s" name text in
  Diagnostic.error ~code:d.code
    ~at:(Span.merge first.span second.span)
    "the types in the signature of `%s` are in the wrong order" name
  |> Diagnostic.here "%s" here
  |> Diagnostic.label ~at:(contradicting ~written d) "this does not fit the signature"
  |> Diagnostic.hint "write the signature as `%s`%s" signature
       (Option.fold others ~none:"" ~some:(Printf.sprintf ", or begin the definition with `%s =`"))
  |> Diagnostic.fix (Printf.sprintf "write `%s`" signature) edits

(* Keeps the message about the definition, because the mistake may be there rather than in the
   signature. *)
let with_hint ({ name; kind; edits; text; _ } : Signature_fact.t) (d : Diagnostic.t) =
  let is_of_a_signature (hint : Diagnostic.hint) =
    hint.topic = Some Number_mistake.Corrected_signature
  in
  let signature = Printf.sprintf "%s :: %s" name text in
  (* A wrong formula is a better explanation than parameters in the wrong order. *)
  let keeps =
    match kind with
    | Parameters _ -> not (List.for_all is_of_a_signature d.hints)
    | Input_and_output | Elements | Parameter_and_result ->
        d.hints <> [] && not (List.exists is_of_a_signature d.hints)
  in
  if keeps then d
  else
    { d with hints = List.filter (fun h -> not (is_of_a_signature h)) d.hints }
    |> Diagnostic.hint "if the types of the signature are in the wrong order, write it as `%s`"
         signature
    |> Diagnostic.fix (Printf.sprintf "write `%s`" signature) edits

let diagnostic words (fact : Signature_fact.t) mistakes =
  let first = List.hd mistakes in
  let d = Facts.diagnostic first in
  match mistakes with
  | [ _ ] when is_about_an_order (Facts.fact first) || is_of_a_decimal fact.kind (Facts.fact first)
    ->
      d
  | [ _ ] when is_about_the_result ~written:fact.written d -> with_hint fact d
  | _ -> in_wrong_order (Wording.sources words) fact d
