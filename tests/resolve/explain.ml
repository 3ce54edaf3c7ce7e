(* The pages that explain the resolver's diagnostics: the faulty example gives
   the code of the page and no other, the cured one none. *)

(* The fenced blocks of a page: what the fence says, and the text. *)
let blocks page =
  let rec outside found = function
    | [] -> List.rev found
    | line :: rest when String.length line > 3 && String.sub line 0 3 = "```" ->
        inside found (String.sub line 3 (String.length line - 3)) [] rest
    | _ :: rest -> outside found rest
  and inside found info text = function
    | [] -> failwith "a block is not closed"
    | "```" :: rest -> outside ((info, String.concat "\n" (List.rev ("" :: text))) :: found) rest
    | line :: rest -> inside found info (line :: text) rest
  in
  outside [] (String.split_on_char '\n' page)

let beside (info, text) =
  match String.split_on_char ' ' info with
  | [ "frob-module"; name ] -> Some (name ^ ".frob", text)
  | _ -> None

let check_page code () =
  let blocks = blocks (Support.read (Printf.sprintf "../../compiler/explain/%s.md" code)) in
  let others = List.filter_map beside blocks in
  let result kind =
    let text = List.assoc kind blocks in
    List.sort_uniq String.compare (Support.codes (fst (Support.load (("main.frob", text) :: others))))
  in
  Alcotest.(check (list string)) "the example" [ code ] (result "frob-error");
  Alcotest.(check (list string)) "the cured example" [] (result "frob")

let () =
  let code file =
    let name = Filename.remove_extension file in
    if Filename.check_suffix file ".md" && List.mem (String.sub name 0 3) [ "E02"; "W02" ] then
      Some name
    else None
  in
  let codes = List.filter_map code (Support.directory "../../compiler/explain") in
  Alcotest.run "explain"
    [ ("pages", List.map (fun c -> Alcotest.test_case c `Quick (check_page c)) codes) ]
