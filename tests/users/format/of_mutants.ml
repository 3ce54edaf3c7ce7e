(* Checks the laws on parts of real programs in which words have been changed, moved, and put on
   other lines: of_mutants COUNT SEED FILE…. Mutants that are not valid programs do not count. *)

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

(* Splits a text into words and the text between them. *)
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

let paragraphs text =
  let add lines found =
    if lines = [] then found else String.concat "\n" (List.rev ("" :: lines)) :: found
  in
  let rec go found lines = function
    | [] -> add lines found
    | "" :: rest -> go (add lines found) [] rest
    | line :: rest -> go found (line :: lines) rest
  in
  go [] [] (String.split_on_char '\n' text)

let change random words =
  let n = Array.length words in
  let i = Random.State.int random n and k = Random.State.int random n in
  match Random.State.int random 7 with
  | 0 -> words.(i) <- ""
  | 1 -> words.(i) <- words.(i) ^ words.(i)
  | 2 -> words.(i) <- words.(k)
  | 3 -> words.(i) <- words.(i) ^ "\n"
  | 4 -> words.(i) <- words.(i) ^ " -- c\n"
  | 5 -> words.(i) <- "    " ^ words.(i)
  | _ ->
      let kept = words.(i) in
      words.(i) <- words.(k);
      words.(k) <- kept

let () =
  let arguments = List.tl (Array.to_list Sys.argv) in
  match arguments with
  | count :: seed :: files ->
      let short text = String.length text > 1 && String.length text < 2000 in
      let parts =
        List.concat_map (fun file -> paragraphs (read file)) files
        |> List.filter short |> Array.of_list
      in
      let random = Random.State.make [| int_of_string seed |] in
      let programs = ref 0 and failed = ref 0 in
      for _ = 1 to int_of_string count do
        let words = words parts.(Random.State.int random (Array.length parts)) in
        for _ = 0 to Random.State.int random 4 do
          change random words
        done;
        let text = String.concat "" (Array.to_list words) in
        if Format_judge.Judge.parsed text <> None then (
          incr programs;
          match Format_judge.Judge.verdict text with
          | Ok _ -> ()
          | Error what ->
              incr failed;
              if !failed <= 3 then Printf.printf "%s\nIt was:\n%s\n" what text)
      done;
      if !failed = 0 && 10 * !programs > int_of_string count then
        Printf.printf "ok   %d changed programs are formatted\n" !programs
      else (
        Printf.printf "FAIL %d of %d changed programs\n" !failed !programs;
        exit 1)
  | _ -> exit 2
