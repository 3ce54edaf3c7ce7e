open Basis
open Resolve

let quote text = Printf.sprintf "`%s`" text

let ambiguous namespace (name : Syntax.Ir.name) candidates =
  let place diagnostic (c : Fact.candidate) =
    Diagnostic.label ~at:c.place "defined in `%s`" c.module_ diagnostic
  in
  let qualified =
    List.map (fun (c : Fact.candidate) -> Printf.sprintf "%s.%s" c.qualifier name.text) candidates
  in
  List.fold_left place
    (Diagnostic.error ~code:"E0210" ~at:name.span "the %s `%s` is ambiguous"
       (Namespace.noun namespace) name.text)
    candidates
  |> Diagnostic.hint "write %s" (String.concat " or " (List.map quote qualified))
  |> List.fold_right (Diagnostic.write name.span) (List.rev qualified)

let declared_twice namespace (name : Syntax.Ir.name) ~(first : Span.t) ~is_function =
  Diagnostic.error ~code:"E0211" ~at:name.span "the %s `%s` is defined twice"
    (Namespace.noun namespace) name.text
  |> Diagnostic.label ~at:first "first defined here"
  |> Diagnostic.hint "%s"
       (if not (String.equal first.file name.span.file) then
          "rename this definition: a test file shares the namespace of its program"
        else if is_function then
          "write one equation for the function, and distinguish its arguments with `case`"
        else "remove one of them, or rename it")

(* {1 Two equations for one name} *)

(* The right-hand side of the variable's equation, if it is on one line and has no guards or
   `where`. *)
let value_of ~text (x : Ir.Local.t) =
  Option.bind (Name_in_text.equation ~text x.span) (fun equation ->
      let start = String.length x.name + String.length " = " in
      let value = String.sub equation start (String.length equation - start) in
      let is_plain = not (List.mem "where" (String.split_on_char ' ' value)) in
      if is_plain && not (String.contains value '|') then Some value else None)

let is_constant value =
  match value with
  | "True" | "False" -> true
  | _ ->
      let first = if value.[0] = '-' && String.length value > 1 then value.[1] else value.[0] in
      Character.is_digit first && not (String.contains value ' ')

(* Does the second equation sometimes override the value of the first, as `v = if stop then 0 else
   v` does? (If the first value is `True` or `False`, the second equation is a latch instead.) *)
let overrides ~name ~before ~after =
  before <> "True" && before <> "False"
  && String.starts_with ~prefix:"if " after
  && String.ends_with ~suffix:(" else " ^ name) after

let because = "an equation holds at every instant, unlike an assignment"

let one_equation name ~before ~after =
  let starts = is_constant before && not (overrides ~name ~before ~after) in
  let by =
    let previous = Printf.sprintf "delay %s %s" (Source.grouped before) name in
    if not starts then Source.grouped before
    else if String.starts_with ~prefix:(name ^ " ") after then previous
    else Source.grouped previous
  in
  let words =
    String.split_on_char ' ' (String.map (fun c -> if Character.is_name c then c else ' ') after)
  in
  match Text_place.replaced ~name ~by after with
  | _ when is_constant before && List.mem "delay" words && List.mem name words ->
      Printf.sprintf
        "remove `%s = %s`: the `delay` in the other equation already has the initial value" name
        before
  | Some (1, value) when starts ->
      Printf.sprintf "write one equation, in which `delay` returns the previous value: `%s = %s`"
        name value
  | Some (1, value) -> Printf.sprintf "write one equation, `%s = %s`, because %s" name value because
  | None when is_constant before && not (is_constant after) ->
      Printf.sprintf "remove `%s = %s`: the other equation defines `%s` at every instant" name
        before name
  | None when String.length before + String.length after < 60 ->
      Printf.sprintf
        "write one equation, because %s; to choose between the two values, write `%s = if c then \
         %s else %s`, with your condition in place of `c`"
        because name after before
  | Some _ | None -> Printf.sprintf "write one equation for `%s`, because %s" name because

let hint_for_one_equation ({ first; second; text; is_equation = _ } : Fact.defined) =
  match (value_of ~text first, value_of ~text second) with
  | Some before, Some after -> one_equation second.name ~before ~after
  | _ ->
      Printf.sprintf
        "write one equation for `%s`, because %s; for its previous value, write `delay 0 %s`, \
         where 0 is the initial value"
        second.name because second.name

let defined_twice (fact : Fact.defined) =
  Diagnostic.error ~code:"E0212" ~at:fact.second.span "`%s` is defined twice here" fact.second.name
  |> Diagnostic.label ~at:fact.first.span "first defined here"
  |> if fact.is_equation then Diagnostic.hint "%s" (hint_for_one_equation fact) else Fun.id

(* {1 Misplaced definitions} *)

(* The parameters in `Float half (Float x) = …`, each with its type *)
let typed_parameters patterns =
  let rec typed (p : Syntax.Ir.pattern) =
    match p.desc with
    | Constructed ({ qualifier = None; name; _ }, [ { desc = Bound x; _ } ]) ->
        [ Some (name.text, x.text) ]
    | Tuple_of parts -> List.concat_map typed parts
    | _ -> [ None ]
  in
  let all = List.concat_map typed patterns in
  if List.mem None all then [] else List.filter_map Fun.id all

let top_level_pattern ~at (pattern : Syntax.Ir.pattern) =
  Diagnostic.error ~code:"E0226" ~at "a top-level definition defines one name, not a pattern"
  |> Diagnostic.hint "%s"
       (match pattern.desc with
       | Constructed ({ qualifier = None; name; _ }, [ { desc = Bound x; _ } ]) ->
           Printf.sprintf "write `%s = …`; to declare its type, write `%s :: %s` on the line above"
             x.text x.text name.text
       | Constructed ({ qualifier = None; name; _ }, { desc = Bound f; _ } :: parameters)
         when typed_parameters parameters <> [] ->
           let types, names = List.split (typed_parameters parameters) in
           Printf.sprintf
             "write the types in a signature, `%s :: %s`, and the definition below it, `%s = …`"
             f.text
             (String.concat " -> " (types @ [ name.text ]))
             (String.concat " " (f.text :: names))
       | Constructed ({ qualifier = None; name; _ }, _) ->
           Printf.sprintf "start the name of a value with a lower-case letter: `%s`"
             (Name_in_text.lower_case name.text)
       | _ -> "define each name separately, or match the pattern in a `let` or `where`")

let misplaced_claim ~at kind =
  let word = Labels.word kind in
  Diagnostic.error ~code:"E0234" ~at "an `%s` is only allowed among the equations of a `proc`" word
  |> Diagnostic.hint
       "move it into a `proc`, as in `proc x -> y where` with `%s \"label\" (y > 0)` on a line \
        below"
       word

let label_without_quotes (label : Syntax.Ir.name) kind =
  let text = Printf.sprintf "\"%s\"" label.text in
  Diagnostic.error ~code:"E0235" ~at:label.span "the label of a `%s` must be in quotes" kind
  |> Diagnostic.hint "write `%s %s = …`" kind text
  |> Diagnostic.write label.span text

let diagnostic suggestions : Fact.in_definitions -> Diagnostic.t = function
  | Ambiguous { namespace; name; candidates } -> ambiguous namespace name candidates
  | Declared_twice { namespace; name; first; is_function } ->
      declared_twice namespace name ~first ~is_function
  | Defined_twice fact -> defined_twice fact
  | Two_labels { first; second } ->
      Diagnostic.error ~code:"E0212" ~at:second "two assertions here have the same label"
      |> Diagnostic.label ~at:first "the first"
  | Two_signatures { first; second } ->
      Diagnostic.error ~code:"E0211" ~at:second.span "`%s` has two signatures" second.text
      |> Diagnostic.label ~at:first.span "the first one is here"
  | Signature_alone { name; bound } ->
      Diagnostic.error ~code:"E0214" ~at:name.span "`%s` has a signature but no definition"
        name.text
      |> Suggestion.add suggestions name.text bound
  | Top_level_pattern { at; pattern } -> top_level_pattern ~at pattern
  | Operator_defined name ->
      Diagnostic.error ~code:"E0227" ~at:name.span "a program cannot define operators"
      |> Diagnostic.hint
           "give the function a name; with backticks you can write it between its arguments: a `f` \
            b"
  | Misplaced_claim { at; kind } -> misplaced_claim ~at kind
  | Bad_label at ->
      Diagnostic.error ~code:"E0235" ~at "this label is empty or contains a line break"
      |> Diagnostic.hint
           "describe in a few words what must hold; the summary of a run shows the label"
  | Label_without_quotes { label; kind } -> label_without_quotes label kind
  | Too_deep at ->
      Diagnostic.error ~code:"E0106" ~at "this is nested more than %d levels deep" Context.deepest
      |> Diagnostic.hint "move the inner parts into definitions of their own"
