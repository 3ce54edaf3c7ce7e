(* Checks that Print's output parses to the same tree. In addition to real programs, it uses
   thousands of mutants, made by deleting, doubling and moving words; those that still parse must
   also survive the round trip. *)

open Programs

let survives program =
  let text = printed program in
  match parse text with
  | _, Some again ->
      if Without_spans.program program = Without_spans.program again then Ok ()
      else Error ("another tree: " ^ text)
  | _, None -> Error ("no longer a program: " ^ text)

let check_file (path, text) =
  let check () =
    match parse text with
    | _, None -> ()
    | _, Some program -> (
        match survives program with Ok () -> () | Error what -> Alcotest.fail what)
  in
  Alcotest.test_case path `Quick check

(* Splits a text into words and the whitespace between them. *)
let words text =
  let is_word c =
    match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | _ -> false
  in
  let n = String.length text in
  let rec stop same i = if i < n && same text.[i] then stop same (i + 1) else i in
  let rec go found i =
    if i >= n then Array.of_list (List.rev found)
    else
      let next =
        if is_word text.[i] then stop is_word i
        else if text.[i] = ' ' then stop (( = ) ' ') i
        else i + 1
      in
      go (String.sub text i (next - i) :: found) next
  in
  go [] 0

(* The parts of a text between empty lines. *)
let paragraphs text =
  let add paragraph found =
    if paragraph = [] then found else String.concat "\n" (List.rev ("" :: paragraph)) :: found
  in
  let rec go found paragraph = function
    | [] -> List.rev (add paragraph found)
    | "" :: rest -> go (add paragraph found) [] rest
    | line :: rest -> go found (line :: paragraph) rest
  in
  go [] [] (String.split_on_char '\n' text)

(* One top-level part of a program, with a few words changed. *)
let mutant =
  let parts =
    List.concat_map (fun (_, text) -> paragraphs text) (written ())
    |> List.filter (fun text -> String.length text < 2000)
    |> Array.of_list
  in
  let change random words =
    let n = Array.length words in
    if n > 0 then
      let i = Random.State.int random n and k = Random.State.int random n in
      match Random.State.int random 4 with
      | 0 -> words.(i) <- ""
      | 1 -> words.(i) <- words.(i) ^ words.(i)
      | 2 -> words.(i) <- words.(k)
      | _ ->
          let kept = words.(i) in
          words.(i) <- words.(k);
          words.(k) <- kept
  in
  fun random ->
    let part = parts.(Random.State.int random (Array.length parts)) in
    let words = words part in
    for _ = 0 to Random.State.int random 3 do
      change random words
    done;
    String.concat "" (Array.to_list words)

let mutants =
  QCheck.Test.make ~name:"mutants that parse" ~count:4000 (QCheck.make ~print:Fun.id mutant)
    (fun text ->
      match parse text with
      | _, None -> true
      | _, Some program -> (
          match survives program with Ok () -> true | Error what -> QCheck.Test.fail_report what))

let run_property test () = QCheck.Test.check_exn ~rand:(Random.State.make [| 20 |]) test

let () =
  Alcotest.run "round trip"
    [
      ("written", List.map check_file (written ()));
      ("made", [ Alcotest.test_case "mutants that parse" `Quick (run_property mutants) ]);
    ]
