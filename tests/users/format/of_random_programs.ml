(* Checks the laws on random programs of tests/meaning/fuzz, with comments and whitespace
   inserted: of_random_programs COUNT SEED. *)

module Lexer = Syntax.Lexer

let chance = Fuzz.Choice.chance

let tokens text =
  let lexer = Lexer.create ignore ~file:"" text in
  let rec go found =
    let token = Lexer.next lexer in
    match token.token with END -> List.rev found | _ -> go (token :: found)
  in
  go []

let comments = ref 0

let inline_comment random =
  incr comments;
  Printf.sprintf "{-%s%d {- nested -} -}" (String.make (Random.State.int random 3) ' ') !comments

let long_comment random =
  incr comments;
  Printf.sprintf "{- %d\n   of two lines%s\n-}" !comments
    (String.make (Random.State.int random 3) ' ')

let line_comment random =
  incr comments;
  Printf.sprintf "--%s %d%s"
    (if chance random 4 then " |" else "")
    !comments
    (String.make (Random.State.int random 3) ' ')

let blanks random n = String.make (Random.State.int random n) ' '

(* Inserts comments and whitespace between the words of one line in [every]; also inserts lines
   with comments, empty lines, and comments at the ends of lines. *)
let sprinkled random ~every text =
  let result = Buffer.create (2 * String.length text) in
  let add = Buffer.add_string result in
  let from = ref 0 in
  let gap = ref "" in
  let at_line_end () =
    if chance random every then add (blanks random 4 ^ " " ^ line_comment random);
    if chance random every then add (blanks random 3)
  in
  let lines_between written =
    (* the text between two lines, with additions *)
    String.iter
      (fun c ->
        if c = '\n' then (
          at_line_end ();
          add "\n";
          if chance random every then add (blanks random 12 ^ line_comment random ^ "\n");
          if chance random (2 * every) then add (blanks random 9 ^ long_comment random ^ "\n");
          if chance random every then add (String.make (Random.State.int random 4) '\n'))
        else Buffer.add_char result c)
      written
  in
  List.iter
    (fun (token : Lexer.token) ->
      let start = token.start.pos_cnum and stop = token.stop.pos_cnum in
      gap := String.sub text !from (start - !from);
      if String.contains !gap '\n' then lines_between !gap
      else (
        add !gap;
        if !gap <> "" && chance random (4 * every) then add (blanks random 4);
        if !gap <> "" && chance random (8 * every) then add (inline_comment random ^ " "));
      add (String.sub text start (stop - start));
      from := stop)
    (tokens text);
  lines_between (String.sub text !from (String.length text - !from));
  Buffer.contents result

let () =
  let count = int_of_string Sys.argv.(1) and seed = int_of_string Sys.argv.(2) in
  let failed = ref 0 and judged = ref 0 and disturbed = ref 0 in
  let judge number text =
    incr judged;
    match Format_judge.Judge.verdict text with
    | Ok _ -> ()
    | Error what ->
        incr failed;
        if !failed <= 3 then
          Printf.printf "program %d of seed %d: %s\nIt was:\n%s\n" number seed what text
  in
  for number = 0 to count - 1 do
    let random = Random.State.make [| seed; number |] in
    let text = Fuzz.Program.make ~seed ~first:number ~count:1 () in
    let every = 1 + Random.State.int random 8 in
    let other = sprinkled random ~every text in
    (* whitespace in the wrong place may make the program invalid *)
    if Format_judge.Judge.parsed other <> None then (
      incr disturbed;
      judge number other)
    else judge number text
  done;
  if !failed = 0 && 4 * !disturbed > count then
    Printf.printf "ok   %d random programs are formatted, %d with comments in them\n" !judged
      !disturbed
  else (
    Printf.printf "FAIL %d of %d random programs, %d with comments\n" !failed !judged !disturbed;
    exit 1)
