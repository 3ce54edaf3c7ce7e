open Text_place

type t = Colon_hint.t = { hint : Basis.Diagnostic.hint option; instead : string option }

(* The Frob spelling of a non-ASCII character, and the hint. *)
let symbol text at = function
  | "\u{00b0}" | "\u{00ba}" ->
      let is_part c = Basis.Character.is_digit c || c = '.' in
      let digits = match ending text at is_part with "" -> "90" | digits -> digits in
      Some ("[deg]", Printf.sprintf "write degrees as a unit: `%s[deg]`" digits)
  | "\u{00b2}" -> Some ("^2", "write `^2`")
  | "\u{00b3}" -> Some ("^3", "write `^3`")
  | "\u{00d7}" | "\u{00b7}" | "\u{22c5}" -> Some ("*", "write `*` to multiply")
  | "\u{00f7}" -> Some ("/", "write `/` to divide")
  | "\u{03c0}" -> Some ("pi", "write `pi`")
  | "\u{03a9}" | "\u{2126}" -> Some ("Ohm", "write the unit as `Ohm`")
  | "\u{00b5}" | "\u{03bc}" -> Some ("u", "write `u` for micro, as in `us` for microseconds")
  | "\u{03bb}" -> Some ("\\", "write an anonymous function as `\\x -> …`")
  | "\u{2192}" -> Some ("->", "write the arrow as `->`")
  | "\u{2190}" -> Some ("<-", "write the arrow as `<-`")
  | "\u{2227}" -> Some ("&&", "write `&&`")
  | "\u{2228}" -> Some ("||", "write `||`")
  | "\u{2212}" | "\u{2013}" -> Some ("-", "write the minus sign as `-`")
  | "\u{2264}" -> Some ("<=", "write `<=`")
  | "\u{2265}" -> Some (">=", "write `>=`")
  | "\u{2260}" -> Some ("/=", "write `/=`")
  | "\u{2018}" | "\u{2019}" -> Some ("'", "write a prime as `'`; put an infix name in backticks")
  | _ -> None

let modules_of_robots =
  [ "Robot"; "Control"; "Geometry"; "Filters"; "Vision"; "Lidar"; "Ros"; "Imu"; "Matrix" ]

(* [Robot] in `#include <Robot.h>` *)
let included line =
  match (String.index_opt line '<', String.index_opt line '>') with
  | Some first, Some last when first < last ->
      Filename.remove_extension (String.trim (String.sub line (first + 1) (last - first - 1)))
  | _ -> ""

(* The hint for `#include <math.h>` or `#include "motor.h"`. *)
let of_include text at =
  let stop = Option.value (String.index_from_opt text at '\n') ~default:(String.length text) in
  let line = String.trim (String.sub text at (stop - at)) in
  match String.split_on_char '"' line with
  | [ _; file; "" ] when file <> "" ->
      let stem = Filename.remove_extension file in
      let is_module =
        stem <> ""
        && Basis.Character.is_upper stem.[0]
        && String.for_all Basis.Character.is_name stem
      in
      Printf.sprintf
        "to import a Frob module, write its name%s; for your own C code, write `foreign include \
         \"%s\"`"
        (if is_module then Printf.sprintf ": `import %s`" stem else ", as in `import Robot`")
        file
  | _ when List.mem (included line) modules_of_robots ->
      Printf.sprintf "write `import %s`" (included line)
  | _ ->
      "remove it: functions such as `sqrt` and `sin` are built in; import other modules by name, \
       as in `import Robot`"

(* The text between this quote and the next one on the line. *)
let in_quotes text at =
  match String.index_from_opt text (at + 1) '\'' with
  | Some stop ->
      let inside = String.sub text (at + 1) (stop - at - 1) in
      let is_infix = List.mem inside [ "mod"; "div"; "rem"; "quot"; "min"; "max"; "to"; "about" ] in
      if is_infix || inside = "" || String.exists (fun c -> c = '\n' || c = '"' || c = '(') inside
      then None
      else Some inside
  | None -> None

(* The definition `speed = 0.3` for `#define SPEED 0.3`. *)
let defined text at =
  let stop = Option.value (String.index_from_opt text at '\n') ~default:(String.length text) in
  match String.split_on_char ' ' (String.trim (String.sub text at (stop - at))) with
  | [ _; name; value ] when name <> "" && String.for_all Basis.Character.is_name name ->
      Printf.sprintf "%s = %s" (String.lowercase_ascii name) value
  | _ -> "vMax = 0.4[m/s]"

(* The Frob expression for `x > 0 ? 1 : 2`, which starts after the last `=`, `->`, `,` or open
   parenthesis before the `?`. *)
let ternary text at =
  let bol = line_start text at in
  let rec start i depth =
    if i <= bol then bol
    else
      match text.[i - 1] with
      | ')' -> start (i - 1) (depth + 1)
      | '(' when depth > 0 -> start (i - 1) (depth - 1)
      | ('(' | ',') when depth = 0 -> i
      | '=' when char_at text i = ' ' && char_at text (i - 2) = ' ' -> i
      | '>' when char_at text (i - 2) = '-' -> i
      | _ -> start (i - 1) depth
  in
  let stop = Option.value (String.index_from_opt text at '\n') ~default:(String.length text) in
  let rec last i depth =
    if i >= stop then stop
    else
      match text.[i] with
      | '(' -> last (i + 1) (depth + 1)
      | ')' -> if depth = 0 then i else last (i + 1) (depth - 1)
      | ';' -> i
      | _ -> last (i + 1) depth
  in
  let first = start at 0 in
  Other_notation.expression (String.sub text first (last at 0 - first))

(* Is the rest of the line a phrase of two words or more, without symbols or digits? *)
let ends_in_words text at =
  let stop = Option.value (String.index_from_opt text at '\n') ~default:(String.length text) in
  let rest = String.trim (String.sub text (at + 1) (stop - at - 1)) in
  let is_letter = function 'a' .. 'z' | 'A' .. 'Z' | ' ' | ',' | '.' -> true | _ -> false in
  String.contains rest ' ' && String.for_all is_letter rest
  && not (List.exists (fun w -> List.mem w [ "then"; "else" ]) (String.split_on_char ' ' rest))

(* Is the rest of the line a single word that occurs nowhere else in the text? *)
let ends_in_a_new_word text at =
  let stop = Option.value (String.index_from_opt text at '\n') ~default:(String.length text) in
  let word = String.trim (String.sub text (at + 1) (stop - at - 1)) in
  let is_letter = function 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false in
  let n = String.length word in
  let occurs_at i =
    String.equal (String.sub text i n) word
    && (not (Basis.Character.is_name (char_at text (i - 1))))
    && not (Basis.Character.is_name (char_at text (i + n)))
  in
  let rec count i =
    if i + n > String.length text then 0 else Bool.to_int (occurs_at i) + count (i + 1)
  in
  n > 1 && n < 40 && String.for_all is_letter word && String.length text < 100_000 && count 0 = 1

(* Are there only spaces before this offset on its line? *)
let begins_line text at =
  let rec go i = i < 0 || text.[i] = '\n' || (text.[i] = ' ' && go (i - 1)) in
  go (at - 1)

let of_character ~text ~at character =
  let next = char_at text (at + String.length character) in
  let starts word =
    let n = String.length word in
    at + n <= String.length text && String.equal (String.sub text at n) word
  in
  let only hint = { hint = Some (Syntax_topic.text hint); instead = None } in
  let both hint instead = { hint = Some (Syntax_topic.text hint); instead = Some instead } in
  match (character, symbol text at character) with
  | _, Some (instead, hint) -> both hint instead
  | "'", None when in_quotes text at <> None ->
      only (Printf.sprintf "put text in double quotes: `\"%s\"`" (Option.get (in_quotes text at)))
  | "'", None when char_at text (at + 2) = '\'' -> only "put text in double quotes"
  | "'", None when Basis.Character.is_lower next || Basis.Character.is_upper next ->
      only "put text in double quotes; put an infix name in backticks, as in ``x `mod` 2``"
  | "'", None -> only "put an infix name in backticks, as in ``x `mod` 2``"
  | ":", None when next = '=' -> only "write an equation with `=`"
  | ":", None -> Colon_hint.of_colon text at
  | "&", None when next <> '&' -> both "write `&&`, or `.&.` for bits" "&&"
  | "&", None -> only "write `&&`, or `.&.` for bits"
  | "#", None when starts "#define" ->
      only (Printf.sprintf "define a constant by an equation: `%s`" (defined text at))
  | "#", None when starts "#include" -> only (of_include text at)
  | "#", None -> both "write `--` to start a comment" "--"
  | "~", None when next = '=' -> only "use `/=` to compare for inequality"
  | ("~" | "\u{00ac}"), None -> (
      match Other_operator.negation text (at + String.length character) with
      | Some (negation, _) when String.ends_with ~suffix:")" negation ->
          only (Printf.sprintf "write `%s`" negation)
      | Some (negation, _) -> both (Printf.sprintf "write `%s`" negation) "not "
      | None -> both "to negate `b`, write `not b`" "not ")
  | "?", None when next = '?' ->
      let rest = String.trim (String.sub text (at + 2) (end_of_line text at - at - 2)) in
      let value = ending text (at - 1) Basis.Character.is_name in
      let default = List.hd (String.split_on_char ' ' (without_closing rest)) in
      only
        (if value = "" || default = "" then
           "use `fromMaybe x m`, where `x` replaces a missing value"
         else Printf.sprintf "use `fromMaybe %s %s`" default value)
  | "?", None ->
      only
        (Printf.sprintf "use `%s`" (Option.value (ternary text at) ~default:"if c then a else b"))
  | "%", None when begins_line text at -> both "write `--` to start a comment" "--"
  | "%", None when char_at text (at - 1) = '[' ->
      let digits = ending text (at - 1) (fun c -> Basis.Character.is_digit c || c = '.') in
      only
        (match float_of_string_opt digits with
        | Some x -> Printf.sprintf "percent is not a unit: write `%g`" (x /. 100.)
        | None -> "percent is not a unit: write 20 percent of x as `0.2 * x`")
  | "%", None when ends_in_words text at || ends_in_a_new_word text at ->
      both "write `--` to start a comment" "--"
  | "%", None -> only "use ``x `mod` y`` for the remainder; 20 percent of x is `0.2 * x`"
  | ("\u{201c}" | "\u{201d}"), None -> only "put text in double quotes"
  | _, None when String.length character > 1 ->
      only "use only `a`–`z`, `A`–`Z`, digits, `_` and `'` in names"
  | _, None -> { hint = None; instead = None }
