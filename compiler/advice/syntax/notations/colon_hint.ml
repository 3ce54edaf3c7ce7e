open Basis
open Syntax_topic
open Text_place

type t = { hint : Diagnostic.hint option; instead : string option }

(* [f x y] for `def f(x, y)`. *)
let of_def words =
  let text = String.concat " " (List.tl words) in
  let blank = function '(' | ')' | ',' | ':' -> ' ' | c -> c in
  let names = List.filter (( <> ) "") (String.split_on_char ' ' (String.map blank text)) in
  let is_name w = String.for_all Character.is_name w in
  if names <> [] && List.for_all is_name names then String.concat " " names else "f x"

(* The equation for the `if` statement on the line that starts at this offset. *)
let chosen text start =
  let rec first i = if char_at text i = ' ' then first (i + 1) else i in
  Option.map
    (fun choice ->
      Diagnostic.suggestion ~topic:(Choice choice) "choose the value in one equation: `%s`" choice)
    (Other_definition.choice text (first start))

(* `if c then a else b` for the `if` on the line that starts at this offset, if a colon ends its
   condition and its branches are values. *)
let chosen_value text start at =
  let rec last_if i =
    if i < start then None
    else if
      i + 3 <= at
      && String.equal (String.sub text i 3) "if "
      && not (Character.is_name (char_at text (i - 1)))
    then Some i
    else last_if (i - 1)
  in
  Option.map
    (fun choice -> Diagnostic.suggestion ~topic:(Choice choice) "write the choice as `%s`" choice)
    (Option.bind (last_if at) (Other_definition.choice_of_values text))

let is_an_else text start at =
  String.equal (String.trim (String.sub text start (at - start))) "else"

let of_block =
  Diagnostic.suggestion ~topic:Colon_of_a_block
    "remove the colon: a block is delimited by its indentation; write a choice as `if c then a \
     else b`"

(* Does the line begin like a record declaration in another language? *)
let declares_a_record line =
  List.mem
    (List.hd (String.split_on_char ' ' (String.trim line)))
    [ "struct"; "typedef"; "class"; "record"; "interface"; "type" ]

(* The maximum number of bytes that {!definition_start} searches back for the start of a
   definition. *)
let farthest = 2000

(* The start of the top-level definition that contains this offset. *)
let definition_start text at =
  let rec back from =
    let start = line_start text from in
    match char_at text start with
    | (' ' | '\n' | '{' | '}' | ',') when start > 0 && at - start < farthest -> back (start - 1)
    | _ -> start
  in
  back at

(* The offset of the innermost open brace. Stops at the start of the definition. *)
let open_brace text at =
  let rec back i closed =
    if i < 0 then None
    else
      match text.[i] with
      | '}' -> back (i - 1) (closed + 1)
      | '{' when closed = 0 -> Some i
      | '{' -> back (i - 1) (closed - 1)
      | '\n' when Character.is_lower (char_at text (i + 1)) && line_start text at <> i + 1 -> None
      | _ -> back (i - 1) closed
  in
  back (at - 1) 0

(* The text before the innermost open brace on its line. *)
let line_of_brace text at =
  Option.map
    (fun brace ->
      let start = line_start text brace in
      String.sub text start (brace - start))
    (open_brace text at)

(* The hint for a record update that contains this offset, such as `{ ...p, x: 1 }`. *)
let changed_copy text at = Option.bind (open_brace text at) (Other_record.changed_copy text)

(* `case 1:` and `default:` of a C `switch`. *)
let starts_a_case text at =
  let rec start i =
    match char_at text (i - 1) with '\n' | '\000' | '{' | ';' -> i | _ -> start (i - 1)
  in
  let start = start at in
  let part = String.trim (String.sub text start (at - start)) in
  String.starts_with ~prefix:"case " part || String.equal part "default"

(* The branch `1 -> x` for a line such as `case 1: return x;`. *)
let branch_of_switch line =
  let without_break text =
    let rec cut i =
      if i + 5 > String.length text then text
      else if String.sub text i 5 = "break" then String.sub text 0 i
      else cut (i + 1)
    in
    String.trim (cut 0)
  in
  let value text =
    let text = without_break text in
    let text =
      if String.ends_with ~suffix:";" text then String.sub text 0 (String.length text - 1) else text
    in
    let text =
      if String.starts_with ~prefix:"return " text then String.sub text 7 (String.length text - 7)
      else text
    in
    if text = "" || String.exists (function ';' | '=' -> true | _ -> false) text then None
    else Other_notation.expression (String.trim text)
  in
  let is_pattern text = text <> "" && String.for_all Character.is_name text in
  match String.index_opt line ':' with
  | None -> None
  | Some colon -> (
      let rest = String.sub line (colon + 1) (String.length line - colon - 1) in
      match (String.split_on_char ' ' (String.sub line 0 colon), value rest) with
      | [ "case"; pattern ], Some value when is_pattern pattern ->
          Some (Printf.sprintf "%s -> %s" pattern value)
      | [ "default" ], Some value -> Some ("_ -> " ^ value)
      | _ -> None)

(* The branches of the C `switch` at this offset, if there are only a few and each is on one line
   with its value. *)
let branches_of_switch text switch =
  let rest = String.sub text switch (String.length text - switch) in
  let rec branches = function
    | [] -> None
    | line :: lines -> (
        match String.trim line with
        | "}" -> Some []
        | "" -> branches lines
        | line ->
            Option.bind (branch_of_switch line) (fun branch ->
                Option.map (List.cons branch) (branches lines)))
  in
  match String.split_on_char '\n' rest with
  | _ :: lines -> (
      match branches lines with
      | Some (_ :: _ :: _ as all) when List.length all <= 4 -> Some all
      | _ -> None)
  | [] -> None

(* The hint for the last C `switch` before this offset. *)
let of_switch text at =
  let before = String.sub text 0 at in
  let inside opener =
    let from = opener + String.length "switch" in
    match (String.index_from_opt before from '(', String.index_from_opt before from ')') with
    | Some first, Some last when first < last && last - first < 30 ->
        Some (String.trim (String.sub before (first + 1) (last - first - 1)))
    | _ -> None
  in
  let rec last_switch i =
    if i < 0 then None
    else if i + 6 <= at && String.equal (String.sub before i 6) "switch" then Some i
    else last_switch (i - 1)
  in
  let switch = last_switch (at - 6) in
  let value = Option.value (Option.bind switch inside) ~default:"x" in
  let case =
    match Option.bind switch (branches_of_switch text) with
    | Some branches ->
        let quoted = List.map (Printf.sprintf "`%s`") branches in
        Printf.sprintf "`case %s of`, and on separate lines below it, without braces, %s" value
          (Enumeration.all quoted)
    | None ->
        Printf.sprintf
          "`case %s of`, and below it one branch on each line, such as `1 -> x`, ending with `_ -> \
           y`"
          value
  in
  Diagnostic.suggestion ~topic:(Switch case) "to choose by value, write %s" case

(* The numbers around the colon of a range, as in `(1:5)` *)
let range text at =
  let rec last i =
    if i < String.length text && Character.is_digit text.[i] then last (i + 1) else i
  in
  let first = ending text at Character.is_digit in
  let stop = last (at + 1) in
  if first <> "" && stop > at + 1 then Some (first ^ ".." ^ String.sub text (at + 1) (stop - at - 1))
  else None

(* `seeds = 1:20` or `seeds = [1:20]` in a trial *)
let seeds text at =
  let start = line_start text at in
  let words = String.split_on_char ' ' (String.sub text start (at - start)) in
  match (range text at, List.rev words) with
  | Some numbers, _ :: "=" :: "seeds" :: _ -> (
      match String.split_on_char '.' numbers with
      | [ first; _; last ] ->
          Some
            (Printf.sprintf "write ``%s `to` %s`` without brackets; it includes both numbers" first
               last)
      | _ -> None)
  | _ -> None

let of_types = "put `::` before a type"

(* The hint for a colon after a field name in braces. *)
let of_field text at =
  let plain hint = { hint = Some (Syntax_topic.text hint); instead = None } in
  let start = definition_start text at in
  let first = String.sub text start (at - start) in
  let rec before_blanks i = if char_at text (i - 1) = ' ' then before_blanks (i - 1) else i in
  let stop = before_blanks at in
  match (line_of_brace text at, ending text stop Character.is_name) with
  | Some _, _ when seeds text at <> None -> plain (Option.get (seeds text at))
  | None, _ when range text at <> None -> plain (Beginnings.no_ranges (Option.get (range text at)))
  | Some _, _ when declares_a_record first ->
      let declaration =
        Option.value
          (Other_definition.record text start)
          ~default:"data Config = Config { speed :: Velocity }"
      in
      { hint = Some (Beginnings.declare_a_record declaration); instead = None }
  | Some _, _ when starts_a_case text at -> { hint = Some (of_switch text at); instead = None }
  | Some _, _ when changed_copy text at <> None -> { hint = changed_copy text at; instead = None }
  | Some line, name when name <> "" && not (String.starts_with ~prefix:"data " line) ->
      let fields =
        match Option.bind (open_brace text at) (Other_record.value text) with
        | Some value -> value
        | None -> name ^ " = …"
      in
      {
        hint = Some (Diagnostic.suggestion "set a field with `=`: `%s`" fields);
        instead = Some (if stop = at then " =" else "=");
      }
  | _ -> plain of_types

let of_class =
  Diagnostic.suggestion ~topic:Class_of_objects
    "Frob has no objects: declare a record with `data`, and define its functions at the top level"

(* An indented `def` below a `class`. *)
let is_a_method text start =
  char_at text start = ' '
  && List.exists
       (String.starts_with ~prefix:"class ")
       (String.split_on_char '\n' (String.sub text 0 start))

(* `x : xs`, a Haskell list, used as a value. *)
let joins text start at =
  let line = String.sub text start (at - start) in
  char_at text (at - 1) = ' '
  && char_at text (at + 1) = ' '
  && (String.contains line '=' || String.contains line '>')
  && line_of_brace text at = None

let of_elements =
  "to combine all elements, write `foldl (+) 0 xs` or `sum xs`; for a single element, write `xs ! \
   0`"

(* `x:rest`, a Haskell pattern. *)
let splits_a_list text at =
  let is_word c = Character.is_name c || c = ' ' in
  let rec after i = if is_word (char_at text i) then after (i + 1) else i in
  let next = after (at + 1) in
  let first = String.trim (String.sub text (at + 1) (next - at - 1)) in
  let ends =
    match (char_at text next, char_at text (next + 1)) with
    | (')' | ':'), _ | '-', '>' -> true
    | _ -> false
  in
  first <> ""
  && (Character.is_lower first.[0] || first = "_")
  && (not (String.contains first ' '))
  && ends
  && line_of_brace text at = None

(* `xs[0:2]`, a Python slice. *)
let is_a_slice text at =
  let digits = ending text at Character.is_name in
  char_at text (at - String.length digits - 1) = '['

(* `[1:10]` after a space, a MATLAB range *)
let is_a_range text at =
  let digits = ending text at Character.is_digit in
  let bracket = at - String.length digits - 1 in
  digits <> ""
  && char_at text bracket = '['
  && not (Character.is_name (char_at text (bracket - 1)) || char_at text (bracket - 1) = ')')

(* `f (x: Float) = …`, a parameter with a type. *)
let types_a_parameter text start at =
  let line = String.sub text start (at - start) in
  char_at text start <> ' '
  && String.contains line '('
  && not (String.exists (function '=' | '{' | '"' -> true | _ -> false) line)

(* `v: Velocity = 0.3[m/s]`, as in Python *)
let typed_parameter text start at =
  let line = String.trim (String.sub text start (end_of_line text at - start)) in
  let prefix = "param " in
  let n = String.length prefix in
  if not (String.starts_with ~prefix line) then None
  else
    Option.map
      (fun (typed : Typed_equation.t) ->
        Printf.sprintf "write `param %s :: %s = %s`" typed.name typed.type_ typed.value)
      (Typed_equation.of_colon (String.sub line n (String.length line - n)))

(* `f : distance -> bool`, with one colon *)
let typed_as_in_elm text start at =
  let name = String.sub text start (at - start) in
  let is_alone = is_a_name (String.trim name) in
  let is_top = is_alone && char_at text start <> ' ' in
  match Other_type.of_signature text at with
  | Some signature
    when is_alone
         && line_of_brace text at = None
         && char_at text (at + 1) = ' '
         && (is_top || String.exists Character.is_upper signature) ->
      Some (Printf.sprintf "%s: %s" of_types signature)
  | Some _ | None -> if is_top && splits_a_list text at then Some of_types else None

let typed_equation text start at =
  match Typed_equation.of_colon (String.sub text start (end_of_line text at - start)) with
  | Some typed when typed.stop = at - start -> Some typed
  | Some _ | None -> None

(* `if c then a else b` for `if c: a else: b` around the colon. *)
let chosen_inline text at =
  let open Let_syntax.Option in
  let start = line_start text at in
  let line = String.sub text start (end_of_line text at - start) in
  let colon = at - start in
  let* first = find "if " line in
  let* last = find ~from:colon " else" line in
  let rest = without_closing (String.sub line (last + 5) (String.length line - last - 5)) in
  let rest =
    if rest <> "" && rest.[0] = ':' then String.sub rest 1 (String.length rest - 1) else rest
  in
  let* condition = Other_notation.expression (String.sub line (first + 3) (colon - first - 3)) in
  let* value = Other_notation.expression (String.sub line (colon + 1) (last - colon - 1)) in
  let* other = Other_notation.expression rest in
  Some (Printf.sprintf "if %s then %s else %s" condition value other)

let is_constructor word =
  word <> "" && Character.is_upper word.[0] && String.for_all Character.is_name word

(* `lambda x, y: x + y` *)
let of_lambda text at words =
  let rec after = function
    | word :: rest when word = "lambda" || String.ends_with ~suffix:"(lambda" word -> rest
    | _ :: rest -> after rest
    | [] -> []
  in
  let name word = String.concat "" (String.split_on_char ',' word) in
  let names = List.map name (after words) in
  let is_name w = w <> "" && String.for_all Character.is_name w in
  let parameters =
    if names <> [] && List.for_all is_name names then String.concat " " names else "x"
  in
  let body = Other_definition.body_of_lambda text (at + 1) in
  Printf.sprintf "write an anonymous function as `\\%s -> %s`" parameters
    (Option.value body ~default:"…")

(* `while True: task`, with the task on the same line *)
let repeated text at =
  let body = without_closing (String.sub text (at + 1) (end_of_line text at - at - 1)) in
  let definition = definition_start text at in
  let first text = List.hd (String.split_on_char ' ' text) in
  let name = first (String.sub text definition (end_of_line text definition - definition)) in
  if body = "" || String.length body > 60 then None
  else if String.equal (first body) name then
    Some
      (Printf.sprintf
         "`%s` repeats anyway, because it calls itself at its end: write `%s`, without the `while`"
         name body)
  else Some (Printf.sprintf "to repeat a task, write `forever %s`" (Source.grouped body))

let of_colon text at =
  let start = line_start text at in
  let words = String.split_on_char ' ' (String.trim (String.sub text start (at - start))) in
  let ends_line = match char_at text (at + 1) with '\n' | '\000' -> true | _ -> false in
  let suggest hint = { hint = Some hint; instead = None } in
  let hint text = suggest (Syntax_topic.text text) in
  match words with
  | "class" :: _ -> suggest of_class
  | "def" :: _ when is_a_method text start -> suggest of_class
  | "def" :: _ ->
      hint
        (match Other_definition.of_python text start with
        | Some d -> Other_definition.advice d
        | None when String.equal (of_def words) "main" -> Other_definition.of_main
        | None -> Printf.sprintf "define a function by an equation: `%s = …`" (of_def words))
  | "if" :: _ when chosen text start <> None -> suggest (Option.get (chosen text start))
  | _ when chosen_value text start at <> None -> suggest (Option.get (chosen_value text start at))
  | _ when is_an_else text start at -> suggest of_block
  | ("assert" | "assume") :: _ ->
      hint
        (Printf.sprintf "add a label in quotes: `%s \"keeps off the wall\" (x > 0)`" (List.hd words))
  | _ when Other_loop.as_value text at <> None ->
      let loop = Option.get (Other_loop.as_value text at) in
      hint (Printf.sprintf "Frob has no `%s`: %s" loop.word loop.hint)
  | "while" :: _ when ends_line && Beginnings.is_forever (String.concat " " words) ->
      hint Beginnings.forever
  | "while" :: _ when Beginnings.is_forever (String.concat " " words) && repeated text at <> None ->
      hint (Option.get (repeated text at))
  | "while" :: _ ->
      hint
        "to repeat a task, write `forever t`; to repeat it while a signal function returns True, \
         write `whileT c t`"
  | "for" :: _
    when ends_line
         && char_at text start = ' '
         && Beginnings.rounds (String.concat " " words) <> None ->
      hint (Beginnings.repeated (Option.get (Beginnings.rounds (String.concat " " words))))
  | _ when List.mem "for" words || List.mem "(for" words -> hint (Other_loop.over_array text start)
  | _ when seeds text at <> None -> hint (Option.get (seeds text at))
  | _ when is_a_range text at -> hint (Beginnings.no_ranges "")
  | _ when is_a_slice text at ->
      hint
        "for part of an array, write `take xs` or `drop xs`; the type of the result determines its \
         size"
  | _ when changed_copy text at <> None -> { hint = changed_copy text at; instead = None }
  | _ when char_at text (at - 1) = '"' && line_of_brace text at <> None ->
      hint "to give values names, declare a record: `data Gains = Gains { p :: Float }`"
  | _ when typed_as_in_elm text start at <> None ->
      hint (Option.get (typed_as_in_elm text start at))
  | _ when splits_a_list text at && not (List.mem "if" words || List.mem "lambda" words) ->
      hint ("an array cannot be split into its first element and the rest; " ^ of_elements)
  | "param" :: _ when typed_parameter text start at <> None ->
      hint (Option.get (typed_parameter text start at))
  | _ when typed_equation text start at <> None ->
      hint (Typed_equation.advice (Option.get (typed_equation text start at)))
  | name :: _ when types_a_parameter text start at ->
      hint
        (Printf.sprintf
           "write the types in a signature on the line above, with the result last: `%s :: Float \
            -> Float`"
           (List.hd (String.split_on_char '(' name)))
  | _ when List.exists (fun w -> w = "lambda" || String.ends_with ~suffix:"(lambda" w) words ->
      hint (of_lambda text at words)
  | [ pattern ] when is_constructor pattern && not ends_line ->
      {
        hint =
          Some (Diagnostic.suggestion "write `->` after a pattern in a `case`: `%s -> …`" pattern);
        instead = Some " ->";
      }
  | _ when ends_line && List.mem "case" words ->
      hint "end the line of a `case` with `of`: `case x of`"
  | _ when ends_line -> suggest of_block
  | _ when joins text start at && not (List.mem "if" words) ->
      hint "an array has a fixed size: write all its elements, as in `[x, 0, 0]`"
  | _ when List.mem "if" words ->
      hint
        (match chosen_inline text at with
        | Some choice -> Printf.sprintf "use `%s`" choice
        | None -> "put `then` after the condition: `if c then a else b`")
  | _ -> of_field text at

let of_each_line (hint : Diagnostic.hint) : Diagnostic.topic list =
  match hint.topic with
  | Some (Choice _ as topic) -> [ topic; Colon_of_a_block ]
  | Some ((Colon_of_a_block | Class_of_objects | Switch _ | Shared _) as topic) -> [ topic ]
  | Some _ | None -> []
