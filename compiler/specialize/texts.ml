open Basis

type t = { numbers : int String_table.t; mutable newest_first : string list }

let create () = { numbers = String_table.create 8; newest_first = [] }

let number t text =
  match String_table.find_opt t.numbers text with
  | Some number -> number
  | None ->
      let number = List.length t.newest_first in
      String_table.replace t.numbers text number;
      t.newest_first <- Text_literal.written text :: t.newest_first;
      number

let all t = match t.newest_first with [] -> [ Text_literal.written "" ] | names -> List.rev names
