open Basis

type expects = Equals | Arrow | Other
type t = { expected : string; hints : string list; expects : expects }

let bug state what = Diagnostic.bug ~stage:"Advice.State_message" "state %d has %s" state what

let expects state = function
  | "equals after a left side" -> Equals
  | "arrow after a parameter" -> Arrow
  | text -> bug state ("an unknown kind: " ^ text)

let add state t line =
  let after prefix =
    let n = String.length prefix in
    if String.starts_with ~prefix line then Some (String.sub line n (String.length line - n))
    else None
  in
  match (after "hint: ", after "expects: ") with
  | Some hint, _ -> { t with hints = t.hints @ [ hint ] }
  | None, Some text -> { t with expects = expects state text }
  | None, None -> bug state ("an unknown line: " ^ line)

let of_state state =
  match Grammar_messages.message state with
  | text -> (
      match List.filter (( <> ) "") (String.split_on_char '\n' text) with
      | expected :: rest ->
          List.fold_left (add state) { expected; hints = []; expects = Other } rest
      | [] -> bug state "an empty message")
  | exception Not_found -> bug state "no message"
