open Basis
open Typing
open Diagnostic

let decided words (decided_by : Expected.decider list) diagnostic =
  match decided_by with
  | { place; decides; _ } :: _ ->
      label ~at:place "because this is %s" (Wording.described words decides) diagnostic
  | [] -> diagnostic

let rec label_reason words (reason : Expected.reason) (expected : Type.t) diagnostic =
  let is_here at = Span.compare at diagnostic.at = 0 in
  let label ~at text = if is_here at then Fun.id else label ~at "%s" text in
  match reason with
  | Unknown | Condition | Statement None -> diagnostic
  | Last_statement reason -> label_reason words reason expected diagnostic
  | Signature { name; at } ->
      let described = Wording.described words expected in
      label ~at
        (match Resolve.Labels.kind_of_check name with
        | Some _ -> Printf.sprintf "the value after this name must be %s" described
        | None -> Printf.sprintf "the signature of `%s` requires %s" name described)
        diagnostic
  | Annotation at ->
      label ~at
        (Printf.sprintf "the annotation requires %s" (Wording.described words expected))
        diagnostic
  | Parameter { callee; at; position; decided_by; _ } ->
      let callee = match callee with Some name -> "`" ^ name ^ "`" | None -> "this" in
      label ~at
        (Printf.sprintf "argument %d of %s is %s" position callee
           (Wording.described words expected))
        diagnostic
      |> decided words decided_by
  | Operand { other; other_type; _ } ->
      label ~at:other.span
        (Printf.sprintf "this is %s" (Wording.described words other_type))
        diagnostic
  | Branch at ->
      label ~at (Printf.sprintf "this branch is %s" (Wording.described words expected)) diagnostic
  | Statement (Some at) ->
      label ~at
        (Printf.sprintf "each task of this `do` must be %s" (Wording.described words expected))
        diagnostic
  | Element at ->
      label ~at
        (Printf.sprintf "the first element is %s" (Wording.described words expected))
        diagnostic
  | Value at ->
      label ~at (Printf.sprintf "the value is %s" (Wording.described words expected)) diagnostic
  | Pattern at ->
      label ~at
        (Printf.sprintf "the pattern matches %s" (Wording.described words expected))
        diagnostic
  | Uses { name; at } ->
      label ~at
        (Printf.sprintf "elsewhere `%s` is used as %s" name (Wording.described words expected))
        diagnostic
  | Output (Signature { name; at }) ->
      label ~at
        (Printf.sprintf "the signature of `%s` requires the output %s" name
           (Wording.described words expected))
        diagnostic
  | Output (Parameter { callee; at; position; decided_by; _ }) ->
      let callee = match callee with Some name -> "`" ^ name ^ "`" | None -> "this" in
      label ~at
        (Printf.sprintf "argument %d of %s has the output %s" position callee
           (Wording.described words expected))
        diagnostic
      |> decided words decided_by
  | Output reason -> label_reason words reason expected diagnostic
  | Field { name; at; constructor; completed } ->
      let whole =
        match (constructor, completed) with
        | Some constructor, Some completed when String.equal diagnostic.code "E0320" ->
            Record_units.completed words constructor (Lazy.force completed)
        | _ -> None
      in
      (match whole with
      | Some (text, edits) ->
          hint "%s" text { diagnostic with hints = []; fixes = [] }
          |> fix "give the numbers their units" edits
      | None ->
          let relate constructor = note "%s" (Record_units.relation constructor) in
          Option.fold constructor ~none:Fun.id ~some:relate diagnostic)
      |> label ~at (Printf.sprintf "the field `%s` is %s" name (Wording.described words expected))

type topic += Definition of string

let defines ~at name d = label ~at "this defines `%s`" name d |> about (Definition name)

(* If there is no better place to point at, labels the place where the variable is bound. *)
let label_subject subject (reason : Expected.reason) diagnostic =
  match (subject, reason) with
  | Some ({ desc = Local local; _ } : Resolve.Ir.expr), (Unknown | Condition | Statement None)
    when Span.compare local.span diagnostic.at <> 0
         && not (List.mem (Definition local.name) diagnostic.about) ->
      label ~at:local.span "`%s` is bound here" local.name diagnostic
  | _ -> diagnostic

let add words ({ ty; because } : Expected.t) diagnostic = label_reason words because ty diagnostic

let add_all words ~subject (expected : Expected.t) diagnostic =
  diagnostic |> add words expected |> label_subject subject expected.because
