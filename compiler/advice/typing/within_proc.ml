open Basis

(* The text from the start of the enclosing definition up to the code. *)
let text_before words (at : Span.t) =
  let sources = Wording.sources words in
  Option.map
    (fun text ->
      let stop = Source.offset sources at.file at.start in
      let rec start i =
        if i = 0 then 0
        else if text.[i - 1] = '\n' && Character.is_lower text.[i] then i
        else start (i - 1)
      in
      let first = if stop < String.length text then start stop else stop in
      String.sub text first (stop - first))
    (Source.text sources at.file)

let words_of text =
  let blank c = if Character.is_name c || c = '=' then c else ' ' in
  List.filter (( <> ) "") (String.split_on_char ' ' (String.map blank text))

(* Could a task start at this word? *)
let mentions_tasks word = String.equal word "do" || String.ends_with ~suffix:"Task" word

let is_certain words at =
  match Option.map words_of (text_before words at) with
  | Some (_ :: "=" :: "proc" :: rest) -> not (List.exists mentions_tasks rest)
  | Some _ | None -> false

let no_tasks text =
  Printf.sprintf
    "a `proc` cannot run a task, because a task takes time: compute a value here, or run %s in a \
     `do`, as in `main = reactimateTask (do …)`"
    (Option.fold text ~none:"the task" ~some:(Printf.sprintf "`%s`"))
