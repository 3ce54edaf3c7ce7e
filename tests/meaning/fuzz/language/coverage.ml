type t = (string, int) Hashtbl.t

let create () : t = Hashtbl.create 256
let found coverage name = Option.value (Hashtbl.find_opt coverage name) ~default:0
let count coverage name n = Hashtbl.replace coverage name (found coverage name + n)
let note coverage name = count coverage name 1
let add coverage other = Hashtbl.iter (count coverage) other

(* {1 Words} *)

let is_letter c =
  ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c = '_' || c = '\''

let is_symbol c = String.contains "+-*/^=<>&|!.@:\\$" c

(* Approximate tokens: names, operators, single characters. *)
let words text visit =
  let length = String.length text in
  let rec last test i = if i < length && test text.[i] then last test (i + 1) else i in
  let rec go i =
    if i < length then (
      let next =
        if is_letter text.[i] then last is_letter i
        else if is_symbol text.[i] then last is_symbol i
        else i + 1
      in
      visit (String.sub text i (next - i));
      go next)
  in
  go 0

let syntax =
  [
    "if";
    "case";
    "let";
    "proc";
    "where";
    "do";
    "data";
    "instance";
    "param";
    "otherwise";
    "\\";
    "->";
    "<-";
    "-<";
    "|";
    "@";
    "::";
    "+";
    "-";
    "*";
    "/";
    "**";
    "^";
    "==";
    "/=";
    "<";
    "<=";
    ">";
    ">=";
    "&&";
    "||";
    ".";
    "!";
    ">>>";
    "<<<";
    "&&&";
    "***";
    "[";
    "{";
  ]

let noted =
  [
    "array of arrays";
    "array of records";
    "chain of array functions";
    "chain in feedback";
    "cascade of modes";
    "modes that hand on";
    "mode that ends in two ways";
    "small root";
    "array of functions";
    "recursion through a switch";
    "recursion of a task";
    "mode with a signal function as parameter";
    "mode with a function as parameter";
    "task with a signal function as parameter";
    "task with a function as parameter";
    "guards and where";
    "array of signal functions";
    "array of machines";
    "switch into the signal function of an event";
    "switch in a switch";
    "event of signal functions";
    "local modes that start each other";
    "local task that starts itself";
    "task that is the whole program";
    "task inside a task";
    "task with state that ends at once";
    "event of functions";
    "function out of a signal function";
    "function out of a switch";
    "feedback through delay";
    "feedback through integral";
    "machine in a circle";
    "wide function";
    "pair of signals";
    "instance in a branch or function";
    "local function";
    "section";
    "both orders";
    "operation on literals";
    "record update";
    "record field";
    "pattern of an array";
    "pun in an expression";
    "pun in a pattern";
    "function by cases";
    "tuple section";
    "guards that fall through";
    "data with parameters";
    "function chosen at run time";
    "assertion";
    "test by itself";
    "golden trace";
    "trial";
    "method of a class";
    "division by zero";
    "NaN";
    "unit";
  ]

(* The names that have a type signature in the text. *)
let prelude_names text =
  let names line =
    match Str.bounded_split_delim (Str.regexp " :: ") line 2 with
    | [ names; _ ] when line.[0] <> ' ' && line.[0] <> '-' ->
        let names =
          if String.starts_with ~prefix:"primitive " names then
            String.sub names 10 (String.length names - 10)
          else names
        in
        let bare name = Str.global_replace (Str.regexp "[() ]") "" name in
        List.map bare (String.split_on_char ',' names)
    | _ -> []
  in
  List.concat_map names (String.split_on_char '\n' text)

let count_words coverage text = words text (note coverage)
let wanted ~prelude = List.sort_uniq String.compare (prelude_names prelude @ syntax @ noted)
let missing ~prelude coverage = List.filter (fun name -> found coverage name = 0) (wanted ~prelude)

let text ~prelude coverage =
  let entry name = Printf.sprintf "%s %d" name (found coverage name) in
  let rec fill line lines = function
    | [] -> List.rev (line :: lines)
    | entry :: others ->
        if line = "" then fill entry lines others
        else if String.length line + String.length entry > 97 then fill entry (line :: lines) others
        else fill (line ^ ", " ^ entry) lines others
  in
  String.concat "\n" (fill "" [] (List.map entry (wanted ~prelude)))
