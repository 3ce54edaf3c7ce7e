open Basis
open Resolve

type rule = Visible.t -> Syntax.Ir.name -> (Diagnostic.t -> Diagnostic.t) option

let is_unit visible = Visible.is_known visible Interface.units

(* `s^2` for `s2`, if `s` is a unit. *)
let power_without_caret : rule =
 fun visible name ->
  let text = name.text in
  let last = String.length text - 1 in
  if last < 1 || text.[last] < '2' || text.[last] > '9' then None
  else
    let stem = String.sub text 0 last in
    if is_unit visible stem then
      let power = Printf.sprintf "%s^%c" stem text.[last] in
      Some
        (fun d ->
          Diagnostic.hint "write the power with `^`: `%s`" power d
          |> Diagnostic.write name.span power)
    else None

let other_unit : rule =
 fun visible name ->
  Other_unit.explain ~is_unit:(is_unit visible) ~text:visible.text name.span name.text

let farad : rule =
 fun _ name ->
  if name.text = "F" then
    Some (Diagnostic.hint "for a farad, write `A s/V`; for a temperature, use kelvin, `K`")
  else None

let word : rule =
 fun visible name ->
  Option.map
    (fun symbol d ->
      Diagnostic.hint "%s"
        (match Name_in_text.unit_of_literal ~text:visible.text name.span with
        | Some (digits, before, after) when before <> "" || after <> "" ->
            Printf.sprintf "the unit is `%s`: write `%s[%s%s%s]`" symbol digits before symbol after
        | Some _ | None -> Printf.sprintf "the unit is `%s`" symbol)
        d
      |> Diagnostic.write name.span symbol)
    (Unit_word.symbol name.text)

let first rules visible (name : Syntax.Ir.name) =
  List.find_map (fun (rule : rule) -> rule visible name) rules

let diagnostic (t : Unknown.t) =
  if t.namespace <> Units then None
  else
    Option.map
      (fun explain -> explain (Unknown.diagnostic t))
      (first [ power_without_caret; other_unit; farad ] t.module_.visible t.name)

(* A word for a unit variable, if no unit has a similar name. *)
let variable_of_letters (t : Unknown.t) =
  let { text = word; span } : Syntax.Ir.name = t.name and text = Unknown.text t in
  let is_of_unit = String.starts_with ~prefix:"un" word || List.mem word [ "any"; "dim"; "var" ] in
  if
    t.namespace = Units
    && Basis.Character.is_lower word.[0]
    && (is_of_unit || Suggest.closest word (Lazy.force t.names) = None)
  then
    Option.map
      (fun (letter, advice) ->
        Unknown.diagnostic t |> Diagnostic.hint "%s" advice |> Diagnostic.write span letter)
      (Unit_variable.advice text (Text_place.offset text span.start) word)
  else None

let of_variable visible (name : Syntax.Ir.name) =
  let explain =
    Option.value
      (first [ word; other_unit; power_without_caret ] visible name)
      ~default:(Diagnostic.note "a unit variable is only allowed in a type")
  in
  Diagnostic.error ~code:(Namespace.unknown Units) ~at:name.span "unknown unit `%s`" name.text
  |> explain
