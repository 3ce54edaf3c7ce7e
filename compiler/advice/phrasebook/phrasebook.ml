open Basis
open Phrase

let bug line = Diagnostic.bug ~stage:"Advice.Phrasebook" "this row cannot be read: %s" line

let place_of line = function
  | "value" -> Value
  | "robot" -> Robot
  | "call" -> Call
  | "reading" -> Reading
  | "speed" -> Speed
  | "controller" -> Controller
  | "array" -> In_array
  | "event" -> In_event
  | "task" -> In_task
  | "operator" -> Operator
  | "object" -> Object
  | "constructor" -> Constructor
  | "type" -> Type
  | "class" -> Class
  | "qualifier" -> Qualifier
  | "module" -> Module
  | "library" -> Library
  | "unit" -> Unit
  | _ -> bug line

(* Splits the rest of a row, which starts at index [from], at each " | ". *)
let rec parts line from =
  let rec separator i =
    if i + 3 > String.length line then None
    else if String.equal (String.sub line i 3) " | " then Some i
    else separator (i + 1)
  in
  match separator from with
  | Some i -> String.sub line from (i - from) :: parts line (i + 3)
  | None -> [ String.sub line from (String.length line - from) ]

let row line =
  let row words place hint replacement =
    match String.split_on_char ' ' words with
    | word :: arguments -> { word; arguments; place = place_of line place; hint; replacement }
    | [] -> bug line
  in
  match parts line 0 with
  | [ words; place ] -> row words place None None
  | [ words; place; hint ] -> row words place (Some hint) None
  | [ words; place; "-"; replacement ] -> row words place None (Some replacement)
  | [ words; place; hint; replacement ] -> row words place (Some hint) (Some replacement)
  | _ -> bug line

let rows =
  lazy
    (String.split_on_char '\n' Words.text
    |> List.filter (fun line -> line <> "" && line.[0] <> '#')
    |> List.map row)

(* The rows by word, in the order of the table. *)
let by_word =
  lazy
    (let table = String_table.create 1024 in
     let add row =
       let others = Option.value (String_table.find_opt table row.word) ~default:[] in
       String_table.replace table row.word (row :: others)
     in
     List.iter add (List.rev (Lazy.force rows));
     table)

let all place word =
  List.filter
    (fun row -> row.place = place)
    (Option.value (String_table.find_opt (Lazy.force by_word) word) ~default:[])

let find place word = match all place word with row :: _ -> Some row | [] -> None

let hint row =
  match (row.hint, row.replacement) with
  | Some hint, _ -> hint
  | None, Some replacement -> Printf.sprintf "write `%s`" replacement
  | None, None -> bug row.word

let is_word text = String.for_all (fun c -> Character.is_name c && c <> '_' && c <> '\'') text

let name row =
  match (row.hint, row.replacement) with
  | None, Some replacement when is_word replacement -> Some replacement
  | _ -> None

(* {1 Arguments} *)

(* Replaces each argument name in the text with the argument. *)
let with_arguments named text =
  let n = String.length text in
  let rec stop i = if i < n && Character.is_name text.[i] then stop (i + 1) else i in
  let rec from i =
    if i >= n then []
    else
      match stop i with
      | j when j = i -> String.make 1 text.[i] :: from (i + 1)
      | j ->
          let word = String.sub text i (j - i) in
          Option.value (List.assoc_opt word named) ~default:word :: from j
  in
  String.concat "" (from 0)

let applied place word arguments =
  let fits row = List.compare_lengths row.arguments arguments = 0 in
  match List.find_opt fits (all place word) with
  | Some ({ replacement = Some text; _ } as row) ->
      Some (with_arguments (List.combine row.arguments arguments) text, row)
  | Some { replacement = None; _ } | None -> None
