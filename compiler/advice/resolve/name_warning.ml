open Basis
open Resolve

(* {1 Unused names} *)

(* Suggests an unused variable in place of a 0: `omega` in `setVelTR v 0`. *)
let instead_of_zero name zero d =
  match zero with
  | Some zero ->
      Diagnostic.label ~at:zero "this is 0" d
      |> Diagnostic.hint "replace this 0 with `%s`" name
      |> Diagnostic.write zero name
  | None -> d

let unused_equation ~at ~circle ~zero name =
  let pronoun = if name = None then "them" else "it" in
  Diagnostic.warning ~code:"W0304" ~at "%s here, but nothing uses %s"
    (match name with
    | None -> "these are defined"
    | Some name -> Printf.sprintf "`%s` is defined" name)
    pronoun
  |> (match circle with
     | [] -> Fun.id
     | [ _ ] -> Diagnostic.note "only its own equation uses it"
     | names ->
         let names = List.map (Printf.sprintf "`%s`") names in
         Diagnostic.note "%s" (Enumeration.all names ^ " are used only by each other"))
  |> instead_of_zero (Option.value name ~default:"") zero
  |> Diagnostic.hint "%s"
       (match name with
       | None -> "use one of them in an output, or remove the equation"
       | Some name ->
           Printf.sprintf
             "use it in an output, or remove it; if it is unused on purpose, rename it to `_%s`"
             name)
  |>
  match name with
  | Some name when name.[0] >= 'a' ->
      Diagnostic.fix (Printf.sprintf "rename it to `_%s`" name) [ (at, "_" ^ name) ]
  | Some _ | None -> Fun.id

let unused_variables (first : Fact.variable) (others : Fact.variable list) =
  match others with
  | [] ->
      Diagnostic.warning ~code:"W0305" ~at:first.at "`%s` is never used" first.name
      |> instead_of_zero first.name first.zero
      |> Diagnostic.hint
           (if first.zero <> None then "if it is unused on purpose, replace it with `_` or `_%s`"
            else if first.is_parameter then
              "use it in the definition; if it is unused on purpose, replace it with `_` or `_%s`"
            else "replace it with `_` or `_%s`")
           first.name
      |> Diagnostic.fix ~safe:(first.zero = None)
           (Printf.sprintf "write `_%s`" first.name)
           [ (first.at, "_" ^ first.name) ]
  | _ ->
      let all = first :: others in
      let told = List.filteri (fun i _ -> i < 3) all in
      let quoted = List.map (fun (v : Fact.variable) -> Printf.sprintf "`%s`" v.name) told in
      Diagnostic.warning ~code:"W0305" ~at:first.at "%s are never used"
        (Enumeration.some quoted ~more:(List.length all - List.length told))
      |> Diagnostic.hint "replace them with `_` or with names such as `_%s`" first.name
      |> Diagnostic.fix ~safe:true
           (Printf.sprintf "write `_%s`, and prefix the other names with `_`" first.name)
           (List.map (fun (v : Fact.variable) -> (v.at, "_" ^ v.name)) all)

let unused_import (idle : Ir.idle) =
  (match idle.listed with
  | Some name -> Diagnostic.warning ~code:"W0306" ~at:idle.at "`%s` is imported but not used" name
  | None ->
      Diagnostic.warning ~code:"W0306" ~at:idle.at "`%s` is imported, but nothing from it is used"
        idle.of_module)
  |> Diagnostic.hint "remove it"
  |> Diagnostic.fix ~safe:true "remove it" [ (idle.whole, "") ]

(* {1 Deprecated names} *)

type advice = Renamed of string | Other of string

let advice text =
  match String.split_on_char '`' text with
  | [ "renamed to "; name; rest ] when String.length rest <= 1 -> Renamed name
  | _ ->
      let text = String.concat " " (List.map String.trim (String.split_on_char '\n' text)) in
      let n = String.length text in
      Other (if String.ends_with ~suffix:"." text then String.sub text 0 (n - 1) else text)

(* Is the name written without a qualifier, so that its span has the length of the name? A qualified
   name is not plain, because the new name might need a different qualifier. *)
let is_plain (name : Ir.Global.t) (span : Span.t) =
  Span.line span.start = Span.line span.stop
  && Span.column span.stop - Span.column span.start = String.length name.name

let deprecated (name : Ir.Global.t) ~at ~text ~is_visible =
  let write fresh = Printf.sprintf "write `%s`, its new name" fresh in
  Diagnostic.warning ~code:"W0317" ~at "`%s` is deprecated" name.name
  |>
  match advice text with
  | Other text -> Diagnostic.hint "%s" text
  | Renamed fresh when not (is_plain name at) -> Diagnostic.hint "%s" (write fresh)
  | Renamed fresh when is_visible ->
      fun d ->
        Diagnostic.hint "%s" (write fresh) d
        |> Diagnostic.fix ~safe:true (Printf.sprintf "write `%s`" fresh) [ (at, fresh) ]
  | Renamed fresh -> Diagnostic.hint "%s" (write fresh ^ ", and import it")

let diagnostic : Fact.warning -> Diagnostic.t = function
  | Hides_local { outer; inner } ->
      Diagnostic.warning ~code:"W0201" ~at:inner.span "`%s` hides a local variable of the same name"
        inner.name
      |> Diagnostic.label ~at:outer.span "this variable is hidden"
  | Hides_parameter { param; inner } ->
      Diagnostic.warning ~code:"W0201" ~at:inner.span "`%s` hides the parameter of the same name"
        inner.name
      |> Diagnostic.label ~at:param.span "setting this parameter has no effect where it is hidden"
      |> Diagnostic.hint "give one of them another name"
  | Unused_equation { at; name; circle; zero } -> unused_equation ~at ~circle ~zero name
  | Unused_variables (first, others) -> unused_variables first others
  | Unused_import idle -> unused_import idle
  | Deprecated { name; at; text; is_visible } -> deprecated name ~at ~text ~is_visible
