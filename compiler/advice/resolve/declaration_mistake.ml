open Basis
open Resolve

(* {1 Parameters and arguments} *)

let parameter_missing (name : Syntax.Ir.name) ~owner ~is_unit =
  Diagnostic.error ~code:"E0221" ~at:name.span "%s variable `%s` is not a parameter of `%s`"
    (if is_unit then "unit" else "type")
    name.text owner
  |> Diagnostic.hint "%s"
       (if is_unit then
          Printf.sprintf "declare it in brackets after the name: `%s[%s]`" owner name.text
        else Printf.sprintf "declare it after the name: `%s %s`" owner name.text)

let counted n noun = Printf.sprintf "%d %s%s" n noun (if n = 1 then "" else "s")

(* `Array 4 Distance` for `Array Distance` *)
let of_elements ~text (at : Span.t) =
  let start = Text_place.offset text at.start in
  let stop = min (String.length text) (Text_place.offset text at.stop) in
  match Other_type.of_text (String.sub text start (max 0 (stop - start))) with
  | Some written when String.starts_with ~prefix:"Array n " written ->
      "Array 4" ^ String.sub written 7 (String.length written - 7)
  | Some _ | None -> "Array 4 Float"

(* `Float[m]` for `Float m` *)
let unit_in_brackets ~text (at : Span.t) =
  let start = Text_place.offset text at.start in
  let stop = min (String.length text) (Text_place.offset text at.stop) in
  match String.split_on_char ' ' (String.sub text start (max 0 (stop - start))) with
  | [ name; unit_ ] when Syntax.Lexer.is_unit unit_ ->
      Some (Printf.sprintf "a unit in a type needs brackets: `%s[%s]`" name unit_)
  | _ -> None

let hint_of_builtin name ~found ~text at =
  match name with
  | "Float" | "Int" -> unit_in_brackets ~text at
  | "Array" when found > 2 -> Some "write a matrix as an array of arrays: `Array 2 (Array 3 Float)`"
  | "Array" ->
      Some
        (Printf.sprintf "write the number of elements and their type, as in `%s`"
           (of_elements ~text at))
  | "SF" when found > 2 -> Some "combine several inputs in a tuple, as in `SF (a, b) c`"
  | "SF" ->
      Some
        "write the types of the input and the output, as in `SF Float Bool`; use `()` for no input"
  | "Task" ->
      Some
        "write the types of the input, the output and the result, as in `Task i o ()`; use `()` \
         for no result"
  | "Program" ->
      Some "write the types of the robot's input and output, as in `Program RobotInput RobotOutput`"
  | _ -> None

(* `SF a b` for `SF a -> b`; [at] is the place of `SF a` *)
let without_arrow ~text (at : Span.t) =
  let start = Text_place.offset text at.start and stop = Text_place.offset text at.stop in
  let rest = String.sub text stop (Text_place.end_of_line text stop - stop) in
  match String.split_on_char '>' rest with
  | [ " -"; output ] when Span.line at.start = Span.line at.stop ->
      let output = String.trim output in
      let is_plain c = Character.is_name c || c = '[' || c = ']' || c = '/' in
      if output <> "" && String.for_all is_plain output then
        Some (Printf.sprintf "%s %s" (String.sub text start (stop - start)) output)
      else None
  | _ -> None

(* `SF Bool (Event ())` for `SF Bool Event ()` *)
let ungrouped (tycon : Interface.tycon) ~found ~places ~text (at : Span.t) =
  let parentheses (place : Span.t) = [ (place.start, "("); (place.stop, ")") ] in
  let by_position (a, _) (b, _) = Stdlib.compare (a : Span.position) b in
  (* one insertion for each position *)
  let rec joined = function
    | (at, first) :: (same, second) :: rest when at = same -> joined ((at, first ^ second) :: rest)
    | first :: rest -> first :: joined rest
    | [] -> []
  in
  let insertions = joined (List.stable_sort by_position (List.concat_map parentheses places)) in
  let stop = Text_place.offset text at.stop in
  let rec changed last = function
    | [] -> String.sub text last (stop - last)
    | (position, inserted) :: rest ->
        let offset = Text_place.offset text position in
        String.sub text last (offset - last) ^ inserted ^ changed offset rest
  in
  let whole = changed (Text_place.offset text at.start) insertions in
  let edit (position, inserted) =
    (Span.make ~file:at.file ~start:position ~stop:position, inserted)
  in
  Diagnostic.error ~code:"E0216" ~at "type `%s` takes %s, not %d" tycon.global.name
    (counted tycon.type_arity "type argument")
    found
  |> Diagnostic.hint "%s"
       (if String.length whole < 80 && not (String.contains whole '\n') then
          Printf.sprintf "add parentheses: `%s`" whole
        else "add parentheses around each argument that has arguments itself")
  |> Diagnostic.fix "add parentheses" (List.map edit insertions)

(* The place of the brackets directly after the name, as in `Distance[cm]`. *)
let brackets_after_name ~text (at : Span.t) =
  let start = Text_place.offset text at.start and stop = Text_place.offset text at.stop in
  match (Text_place.find ~from:start "[" text, Text_place.find ~from:start "]" text) with
  | Some first, Some last when last < stop && Span.line at.start = Span.line at.stop ->
      Some
        {
          at with
          start = Span.forward (first - start) at.start;
          stop = Span.forward (last + 1 - start) at.start;
        }
  | _ -> None

let wrong_arity (tycon : Interface.tycon) ~of_units ~expected ~found ~text at =
  let name = tycon.global.name in
  let noun = if of_units then "unit argument" else "type argument" in
  let diagnostic =
    if of_units && expected = 0 then
      Diagnostic.error ~code:"E0216" ~at "type `%s` takes no unit" name
    else
      Diagnostic.error ~code:"E0216" ~at "type `%s` takes %s, not %d" name (counted expected noun)
        found
  in
  let is_builtin = Interface.is_builtin tycon in
  let hint =
    match Other_type.changed text (Text_place.offset text at.start) with
    | _ when String.equal name "SF" && found = 1 && without_arrow ~text at <> None ->
        Option.map
          (Printf.sprintf "write `%s`, without an arrow between the input and the output")
          (without_arrow ~text at)
    | Some signature -> Some ("write " ^ signature)
    | None when is_builtin -> hint_of_builtin name ~found ~text at
    | None -> None
  in
  match hint with
  | Some hint -> Diagnostic.hint "%s" hint diagnostic
  | None when of_units && expected = 0 ->
      (if is_builtin then diagnostic else Diagnostic.label ~at:tycon.span "declared here" diagnostic)
      |> Diagnostic.hint "write `%s`, without the unit" name
      |> Option.fold (brackets_after_name ~text at) ~none:Fun.id ~some:(fun place ->
             Diagnostic.fix "remove the unit" [ (place, "") ])
  | None when of_units && expected = 1 && found = 0 ->
      Diagnostic.label ~at:tycon.span "declared here" diagnostic
      |> Diagnostic.hint
           "write `%s[1]` for plain numbers, or add the unit of the numbers, as in `%s[m]`" name
           name
  | None when is_builtin -> diagnostic
  | None ->
      Diagnostic.label ~at:tycon.span "declared here" diagnostic
      |>
      if found < expected && not of_units then
        Diagnostic.hint "give it %s, as in `%s`" (counted expected noun)
          (String.concat " " (name :: List.init expected (fun _ -> "Float")))
      else Fun.id

let size_not_a_number ~at alias =
  (match alias with
  | Some alias ->
      Diagnostic.error ~code:"E0330" ~at "`%s` is part of a size, but it is not a number" alias
  | None -> Diagnostic.error ~code:"E0330" ~at "this type is part of a size, but it is not a number")
  |> Diagnostic.hint "define the size as a number, as in `type N = 25`"

(* The signature, with the parenthesized size at this place replaced by a new variable. *)
let with_size_variable ~text (at : Span.t) =
  let start = Text_place.line_start text (Text_place.offset text at.start) in
  let offset = Text_place.offset text at.start - start in
  let line = String.sub text start (Text_place.end_of_line text start - start) in
  let is_free letter =
    let word = String.map (fun c -> if Character.is_name c then c else ' ') line in
    not (List.mem letter (String.split_on_char ' ' word))
  in
  match
    ( String.rindex_from_opt line offset '(',
      String.index_from_opt line offset ')',
      List.find_opt is_free [ "k"; "m"; "j" ] )
  with
  | Some first, Some last, Some letter when Text_place.find " :: " line <> None ->
      let inside = String.sub line (first + 1) (last - first - 1) in
      if String.contains inside '(' then None
      else
        Some
          (String.trim
             (String.sub line 0 first ^ letter
             ^ String.sub line (last + 1) (String.length line - last - 1)))
  | _ -> None

let size_of_variable ~text ~at variable =
  Diagnostic.error ~code:"E0330" ~at
    "`%s` is a variable, but arithmetic on sizes needs known numbers" variable
  |> Diagnostic.hint "use another variable for the result, as in `%s`"
       (Option.value (with_size_variable ~text at) ~default:"take :: Array n a -> Array k a")

(* {1 Circles} *)

(* Shows a cycle as `A` → `B` → `A`. *)
let path names =
  match names with
  | [] -> ""
  | first :: _ -> String.concat " → " (List.map (Printf.sprintf "`%s`") (names @ [ first ]))

let through name ~at = Diagnostic.label ~at "through `%s`" name

let type_circle (main : Ir.type_declaration) circle =
  let diagnostic =
    match main.definition with
    | Data _ ->
        Diagnostic.error ~code:"E0218" ~at:main.span "the data type `%s` contains itself"
          main.tycon.name
        |> Diagnostic.note "every value has a fixed size, so a data type cannot be recursive"
        |> Diagnostic.hint
             "use an array of a fixed size, such as `Array 8 Distance`; if the number of valid \
              elements varies, keep their count in a second field"
    | Alias _ | Builtin | Foreign _ ->
        Diagnostic.error ~code:"E0217" ~at:main.span
          "the type alias `%s` is defined in terms of itself" main.tycon.name
  in
  let label diagnostic (d : Ir.type_declaration) =
    if d == main then diagnostic else through d.tycon.name ~at:d.span diagnostic
  in
  let names = List.map (fun (d : Ir.type_declaration) -> d.tycon.name) circle in
  List.fold_left label diagnostic circle
  |> if List.length names > 1 then Diagnostic.note "%s" (path names) else Fun.id

let unit_circle (main : Ir.unit_declaration) others =
  let label diagnostic (d : Ir.unit_declaration) = through d.unit_name.name ~at:d.span diagnostic in
  List.fold_left label
    (Diagnostic.error ~code:"E0219" ~at:main.span "the unit `%s` is defined in terms of itself"
       main.unit_name.name)
    others

let class_circle (main : Ir.class_) others =
  let label diagnostic (c : Ir.class_) = through c.class_.name ~at:c.span diagnostic in
  List.fold_left label
    (Diagnostic.error ~code:"E0229" ~at:main.span "the class `%s` is its own superclass"
       main.class_.name)
    others

(* {1 Classes and instances} *)

let not_a_method suggestions (class_ : Interface.class_) (name : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0230" ~at:name.span "`%s` is not a method of the class `%s`" name.text
    class_.global.name
  |> Diagnostic.label ~at:class_.span "the methods are declared here"
  |> Suggestion.add suggestions name.text (lazy class_.methods)
  |> fun d ->
  if d.hints <> [] then d
  else
    Diagnostic.hint
      "if it is a separate function, move it to the left margin; if every `%s` must have it, add \
       its signature to the class"
      class_.global.name d

let twice what (first : Syntax.Ir.name) (second : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0211" ~at:second.span "the %s `%s` is declared twice" what second.text
  |> Diagnostic.label ~at:first.span "first declared here"

let diagnostic suggestions : Fact.in_types -> Diagnostic.t = function
  | Parameter_missing { name; owner; is_unit } -> parameter_missing name ~owner ~is_unit
  | Wrong_arity { at; tycon; of_units; expected; found; text } ->
      wrong_arity tycon ~of_units ~expected ~found ~text at
  | Ungrouped_arguments { at; tycon; found; places; text } ->
      ungrouped tycon ~found ~places ~text at
  | Representation_without_parameter { name; owner } ->
      Diagnostic.error ~code:"E0222" ~at:name.span
        "`%s` can be a Float or an Int, but `%s` has no parameter that decides which" name.text
        owner
      |> Diagnostic.hint "write `Float[…]` or `Int[…]`, or make the whole type a parameter"
  | Size_not_a_number { at; alias } -> size_not_a_number ~at alias
  | Size_of_variable { at; variable; text } -> size_of_variable ~text ~at variable
  | Type_circle { main; circle } -> type_circle main circle
  | Unit_circle { main; others } -> unit_circle main others
  | Class_circle { main; others } -> class_circle main others
  | Parameter_twice { first; second } -> twice "parameter" first second
  | Field_twice { first; second } -> twice "field" first second
  | Parameter_is_a_unit name ->
      Diagnostic.error ~code:"E0224" ~at:name.span
        "the unit parameter `%s` has the same name as a unit" name.text
      |> Diagnostic.hint "use a letter that is not a unit, such as `u`"
  | Unit_of_one_letter name ->
      Diagnostic.error ~code:"E0220" ~at:name.span
        "the name of the unit `%s` is a single lower-case letter" name.text
      |> Diagnostic.note
           "single lower-case letters are reserved for unit variables and the library's units"
      |> Diagnostic.hint "use a name of at least two characters, or a capital letter"
  | Pattern_in_instance at ->
      Diagnostic.error ~code:"E0226" ~at
        "an instance must define each method by name, not with a pattern"
  | Method_twice { first; second } ->
      Diagnostic.error ~code:"E0211" ~at:second.span "the method `%s` is defined twice" second.text
      |> Diagnostic.label ~at:first.span "first defined here"
  | Not_a_method { class_; name } -> not_a_method suggestions class_ name
  | Signature_in_instance { class_; name } ->
      Diagnostic.error ~code:"E0231" ~at:name.span "an instance cannot contain a signature"
      |> Diagnostic.label ~at:class_.span "the class declares the type of `%s`" name.text
      |> Diagnostic.hint "remove the signature"
