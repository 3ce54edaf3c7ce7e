open Basis
open Resolve

type outcome = Report of Diagnostic.t | Import of Imports.absent | Class_as_type | Silent

(* `0.5 m/s`, a unit without brackets. Only its first name is reported. *)
let unit_without_brackets (t : Unknown.t) =
  Option.map
    (fun { Name_in_text.number; measure; whole; is_first } ->
      let text = Printf.sprintf "%s[%s]" number measure in
      if not is_first then Silent
      else
        Report
          (Diagnostic.error ~code:"E0205" ~at:t.name.span "the unit `%s` needs brackets" measure
          |> Diagnostic.hint "write it directly after its number: `%s`" text
          |> Diagnostic.fix ~safe:true (Printf.sprintf "write `%s`" text) [ (whole, text) ]))
    (Rewritten.unit_after_number t)

(* A name whose definition has already been reported. *)
let of_a_reported_definition (t : Unknown.t) =
  let reported =
    match t.namespace with
    | Constructors -> Lazy.force t.module_.in_capitals
    | Values -> Lazy.force t.module_.without_definition
    | Types | Units | Classes -> []
  in
  if List.mem t.name.text reported then Some Silent else None

(* A name from a module that is imported with `qualified`. *)
let of_a_qualified_import (t : Unknown.t) =
  let has (i : Visible.import) =
    (not i.unqualified) && (not (Visible.is_implied i)) && t.is_in i.names
  in
  match List.find_opt has t.module_.visible.imports with
  | Some { qualifiers = q :: _; _ } ->
      let text = q ^ "." ^ t.name.text in
      Some
        (Other_meaning.diagnostic t
        |> Diagnostic.hint "its module is imported with `qualified`: write `%s`" text
        |> Diagnostic.write t.name.span text)
  | Some _ | None -> None

let typed_left t =
  let rule rule =
    Option.map (function Typed_left.Report d -> Report d | Typed_left.Reported -> Silent) (rule t)
  in
  List.find_map rule Typed_left.rules

let has_word word text =
  let word_or_blank c = if Character.is_name c then c else ' ' in
  List.mem word (String.split_on_char ' ' (String.map word_or_blank text))

(* `total :: List[float] -> float`. The names in the brackets are not reported, because the type
   before them is. *)
let type_of_another_language (t : Unknown.t) =
  let text = Unknown.text t and span = t.name.span in
  let at = Text_place.offset text span.start in
  match (t.namespace, Other_type.signature text at) with
  | Types, Some signature when not (has_word t.name.text signature) ->
      Some
        (Report
           (Unknown.diagnostic t
           |> Diagnostic.hint "write %s" (Option.get (Other_type.of_signature text at))))
  | Units, Some signature
    when Other_type.changed text at <> None
         && ((not (has_word t.name.text signature)) || Character.is_upper t.name.text.[0]) ->
      Some Silent
  | _ -> None

let class_ (t : Unknown.t) =
  if t.namespace = Types && Visible.is_known t.module_.visible Interface.classes t.name.text then
    Some Class_as_type
  else None

(* `Twist { linear = v, angular = 0 }`, a robot command in ROS *)
let twist (t : Unknown.t) =
  let commands_a_robot = Visible.is_known t.module_.visible Interface.values "setVelTR" in
  if t.namespace = Constructors && String.equal t.name.text "Twist" && commands_a_robot then
    let written = Name_in_text.record ~text:(Unknown.text t) t.name.span in
    let field name otherwise =
      let value = Option.bind written (fun (_, fields) -> List.assoc_opt name fields) in
      Option.fold value ~none:otherwise ~some:Source.grouped
    in
    let text =
      Printf.sprintf "roMake (setVelTR %s %s)" (field "linear" "v") (field "angular" "omega")
    in
    Some
      (Unknown.diagnostic t
      |> Diagnostic.hint "a robot's output is a command, not a `Twist`: write `%s`" text
      |> Option.fold written ~none:Fun.id ~some:(fun (whole, _) -> Diagnostic.write whole text))
  else None

let of_the_library t =
  match Other_proc.of_this t with
  | Some _ -> None
  | None -> Option.map (fun absent -> Import absent) (Imports.absent t)

let other_spelling (t : Unknown.t) =
  if t.namespace = Values && Of_robot.is_a_word t.name.text then None
  else
    Option.map
      (fun other ->
        Other_meaning.diagnostic t
        |> Diagnostic.hint "did you mean `%s`?" other
        |> Diagnostic.write t.name.span other)
      (Other_meaning.spelling t)

(* The first rule that applies determines the outcome. Rules whose explanation is certain come
   first. Rules that look at the text around the name come before rules that look only at the
   name. *)
let outcome suggestions (t : Unknown.t) =
  let report rule t = Option.map (fun d -> Report d) (rule t) in
  let rules =
    [
      unit_without_brackets;
      of_a_reported_definition;
      typed_left;
      type_of_another_language;
      report Unknown_unit.diagnostic;
      report Of_another_language.controller;
      report of_a_qualified_import;
      class_;
      report twist;
      of_the_library;
      report Other_proc.of_this;
      report Other_proc.of_lambda;
      report other_spelling;
      report Other_proc.of_an_input;
    ]
    @ List.map report Of_another_language.rules
    @ [ report Other_proc.of_another; report Unknown_unit.variable_of_letters ]
  in
  match List.find_map (fun rule -> rule t) rules with
  | Some outcome -> outcome
  | None -> Report (Of_robot.diagnostic suggestions t)

let class_hint =
  "write the class before `=>` and use a type variable, as in `(HasSonar i, DiffDrive o) => SF i o`"

let class_as_type (name : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0207" ~at:name.span "`%s` is a class, not a type" name.text
  |> Diagnostic.hint "%s" class_hint
