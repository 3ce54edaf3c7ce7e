(* Checks the laws on those files on the command line that are valid programs; with
   `--formatted`, checks that they are already formatted. *)

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let () =
  let names = List.tl (Array.to_list Sys.argv) in
  let should_be, files = List.partition (( = ) "--formatted") names in
  let programs = ref 0 in
  List.iter
    (fun file ->
      let text = read file in
      if Format_judge.Judge.parsed text <> None then (
        incr programs;
        match Format_judge.Judge.verdict text with
        | Error what -> Printf.printf "%s: %s\n" file what
        | Ok result ->
            if should_be <> [] && not (String.equal result text) then
              Printf.printf "%s is not formatted: frobc format %s\n" file file))
    files;
  if !programs < 5 then print_endline "there are hardly any programs"
