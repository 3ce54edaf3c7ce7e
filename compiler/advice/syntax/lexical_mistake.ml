open Basis
open Syntax

let error ~code ~at format = Diagnostic.error ~code ~at format

(* {1 Numbers} *)

let is_suffix rest = List.mem rest [ "f"; "F"; "d"; "L"; "u" ]

let hint_after_number ~base ~number ~rest ~has_unit =
  match base with
  | 16 -> "after `0x`, use the digits `0` to `9` and `a` to `f`"
  | 8 -> "after `0o`, use the digits `0` to `7`"
  | 2 -> "after `0b`, use the digits `0` and `1`"
  | _ when rest.[0] = '_' -> "use `_` only between two digits"
  | _ when is_suffix rest -> Printf.sprintf "remove the suffix: `%s`" number
  | _ when has_unit -> Printf.sprintf "put the unit in brackets: `%s[%s]`" number rest
  | _ ->
      Printf.sprintf "for a product, write `%s * %s`; for a unit, write `%s[%s]`" number rest number
        rest

let number_followed ~at ~base ~number ~rest ~has_unit =
  let problem =
    if rest = "" then "has no digits" else Printf.sprintf "is directly followed by `%s`" rest
  in
  error ~code:"E0105" ~at "the number `%s` %s" number problem
  |> Diagnostic.hint "%s" (hint_after_number ~base ~number ~rest ~has_unit)
  |>
  if base <> 10 then Fun.id
  else if is_suffix rest then Diagnostic.write at number
  else if rest <> "" && not (String.contains rest '_') then
    Diagnostic.write at (Printf.sprintf "%s[%s]" number rest)
  else Fun.id

let with_digit ~at ~where text d =
  Diagnostic.hint "write a digit %s the decimal point: `%s`" where text d
  |> Diagnostic.write at text

let too_long ~at what ~most ~length =
  error ~code:"E0105" ~at "a %s has at most %d characters, but this one has %d" what most length

(* {1 Characters} *)

type colons = Diagnostic.topic list

let no_colons = []

(* Reports only the first unexpected character of a line, because the others probably have the same
   cause. *)
let unexpected_character ~text colons ~at ~character ~offset ~is_first =
  let is_colon = character = ":" in
  if not (is_first || is_colon) then (None, colons)
  else
    let shown =
      if character >= " " && character <> "\x7f" then Printf.sprintf "`%s`" character
      else Printf.sprintf "with code %d" (Char.code character.[0])
    in
    let { Character_hint.hint; instead } = Character_hint.of_character ~text ~at:offset character in
    let is_told (hint : Diagnostic.hint) =
      Option.fold hint.topic ~none:false ~some:(fun topic -> List.mem topic colons)
    in
    let diagnostic =
      if is_first && not (is_colon && Option.fold hint ~none:false ~some:is_told) then
        Some
          (error ~code:"E0103" ~at "unexpected character %s" shown
          |> Option.fold hint ~none:Fun.id ~some:Diagnostic.suggest
          |> Option.fold instead ~none:Fun.id ~some:(Diagnostic.write at))
      else None
    in
    ( diagnostic,
      if is_colon then Option.fold hint ~none:[] ~some:Colon_hint.of_each_line @ colons else colons
    )

let of_problem ~at : Lexical_fact.problem -> Diagnostic.t option = function
  | Unexpected_character _ -> None
  | Comment_not_closed ->
      Some
        (error ~code:"E0104" ~at "this comment is never closed"
        |> Diagnostic.hint "close it with `-}`; comments nest, so each `{-` needs its own `-}`")
  | Text_not_closed ->
      Some
        (error ~code:"E0104" ~at "this string is not closed on its line"
        |> Diagnostic.hint "end the string with another `\"` on the same line")
  | Unknown_escape ->
      Some
        (error ~code:"E0105" ~at "unknown escape sequence in a string"
        |> Diagnostic.hint "use `\\\"`, `\\\\`, `\\n` or `\\t`")
  | Long_name { most; length } -> Some (too_long ~at "name" ~most ~length)
  | Long_number { most; length } -> Some (too_long ~at "number" ~most ~length)
  | Number_followed { base; number; rest; has_unit } ->
      Some (number_followed ~at ~base ~number ~rest ~has_unit)
  | No_fraction { number } ->
      Some
        (error ~code:"E0105" ~at "the number `%s.` has no digit after its decimal point" number
        |> with_digit ~at ~where:"after" (number ^ ".0"))
  | No_whole_part { fraction } ->
      Some
        (error ~code:"E0105" ~at "the number `%s` has no digit before its decimal point" fraction
        |> with_digit ~at ~where:"before" ("0" ^ fraction))

let diagnostic ~text colons ({ at; problem } : Lexical_fact.t) =
  match problem with
  | Unexpected_character { character; offset; is_first } ->
      unexpected_character ~text colons ~at ~character ~offset ~is_first
  | _ -> (of_problem ~at problem, colons)
