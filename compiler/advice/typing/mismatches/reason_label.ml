open Basis
open Typing
open Diagnostic

let decided words (decided_by : Expected.decider list) diagnostic =
  match decided_by with
  | { place; decides; _ } :: _ ->
      label ~at:place "because this is %s" (Wording.described words decides) diagnostic
  | [] -> diagnostic

let ordinal = function
  | 1 -> "the first"
  | 2 -> "the second"
  | 3 -> "the third"
  | n -> Printf.sprintf "the %dth" n

let part_name : Expected.part -> string = function
  | Of_parameter -> "the parameter"
  | Of_result -> "the result"
  | Of_input -> "the input"
  | Of_output -> "the output"
  | Of_tuple n -> ordinal n ^ " component"
  | Of_array -> "an element"
  | Of_data -> "a field"

let part_of parts whole = String.concat " of " (List.map part_name parts @ [ whole ])

(* Says what the signature or annotation requires. A definition with parameters is written like its
   result, so the result is not mentioned if that is clear. *)
let required ~by ~of_ (parts : Expected.part list) described =
  let rec without_result : Expected.part list -> _ = function
    | [] | [ Of_result ] -> []
    | [ Of_output; Of_result ] -> [ Expected.Of_output ]
    | part :: parts -> part :: without_result parts
  in
  match without_result parts with
  | [] -> Printf.sprintf "%s requires %s" by described
  | [ ((Of_parameter | Of_input | Of_output) as part) ] ->
      Printf.sprintf "%s requires %s %s" by (part_name part) described
  | parts ->
      Printf.sprintf "%s %s is %s" of_ (String.concat " of " (List.map part_name parts)) described

(* The declared type of the parameter. The type that the application gives it may already contain
   parts of the wrong argument; for the first argument, nothing else can have changed it. *)
let declared_parameter words (expected : Expected.t) =
  match (expected, Type.expand expected.ty) with
  | ( { because = Parameter { head = Some { desc = Global g; _ }; position = 1; _ }; parts = []; _ },
      Function _ ) ->
      Wording.declared_parameter words g 1
  | _ -> None

let rec label_reason words (reason : Expected.reason) (expected : Expected.t) diagnostic =
  let is_here at = Span.compare at diagnostic.at = 0 in
  let label ~at text = if is_here at then Fun.id else label ~at "%s" text in
  let described = Wording.described words expected.ty in
  let parts = expected.parts in
  let is whole = Printf.sprintf "%s is %s" (part_of parts whole) described in
  match reason with
  | Unknown | Condition | Statement None -> diagnostic
  | Last_statement reason | Output reason -> label_reason words reason expected diagnostic
  | Signature { name; at } ->
      label ~at
        (match Resolve.Labels.kind_of_check name with
        | Some _ -> Printf.sprintf "the value after this name must be %s" described
        | None ->
            required
              ~by:(Printf.sprintf "the signature of `%s`" name)
              ~of_:(Printf.sprintf "by the signature of `%s`," name)
              parts described)
        diagnostic
  | Annotation at ->
      label ~at (required ~by:"the annotation" ~of_:"by the annotation," parts described) diagnostic
  | Parameter { callee; at; position; decided_by; _ } ->
      let callee = match callee with Some name -> "`" ^ name ^ "`" | None -> "this" in
      let argument = Printf.sprintf "argument %d of %s" position callee in
      label ~at
        (match (parts, declared_parameter words expected) with
        | [], Some declared -> Printf.sprintf "%s is `%s`" argument declared
        | [ Of_output ], _ -> Printf.sprintf "%s has the output %s" argument described
        | _ -> is argument)
        diagnostic
      |> decided words decided_by
  | Operand { other; other_type; _ } ->
      label ~at:other.span
        (Printf.sprintf "this is %s" (Wording.described words other_type))
        diagnostic
  | Branch at -> label ~at (is "this branch") diagnostic
  | Statement (Some at) ->
      label ~at
        (Printf.sprintf "%s must be %s" (part_of parts "each task of this `do`") described)
        diagnostic
  | Element at -> label ~at (is "the first element") diagnostic
  | Value at -> label ~at (is "the value") diagnostic
  | Pattern at ->
      label ~at (Printf.sprintf "%s matches %s" (part_of parts "the pattern") described) diagnostic
  | Uses { name; at } ->
      label ~at
        (Printf.sprintf "elsewhere %s is used as %s"
           (part_of parts (Printf.sprintf "`%s`" name))
           described)
        diagnostic
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
      |> label ~at (is (Printf.sprintf "the field `%s`" name))

type topic += Definition of string

let defines ~at name d = label ~at "this defines `%s`" name d |> about (Definition name)

let hides words (x : Resolve.Ir.Local.t) ((g : Resolve.Ir.Global.t), ty) d =
  let kind = match Type.expand ty with Signal_function _ -> "signal function" | _ -> "function" in
  let owner =
    match Wording.binding words g with
    | Some b when String.equal b.span.file x.span.file -> "this program"
    | Some _ | None -> Printf.sprintf "`%s`" g.module_
  in
  label ~at:x.span "this local `%s` hides the %s `%s` of %s" x.name kind x.name owner d
  |> hint "give the local definition another name, such as `%s1`, so that `%s` is the %s here"
       x.name x.name kind

(* If there is no better place to point at, labels the place where the variable is bound. *)
let label_subject subject (reason : Expected.reason) diagnostic =
  match (subject, reason) with
  | Some ({ desc = Local local; _ } : Resolve.Ir.expr), (Unknown | Condition | Statement None)
    when Span.compare local.span diagnostic.at <> 0
         && not (List.mem (Definition local.name) diagnostic.about) ->
      label ~at:local.span "`%s` is bound here" local.name diagnostic
  | _ -> diagnostic

let add words (expected : Expected.t) diagnostic =
  label_reason words expected.because expected diagnostic

let add_all words ~subject (expected : Expected.t) diagnostic =
  diagnostic |> add words expected |> label_subject subject expected.because
