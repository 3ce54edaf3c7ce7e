(* Checks that the verdicts of `frobc test` on random programs are those that the interpreter
   computes for the same conditions. usage: verdicts FROBC LIBRARY RUNTIME MODULES SEED.

   Each module has several programs. Each program has a test, whose observer generates the input
   (Fuzz.Trying), and two golden traces: the one that the interpreter computes, and a copy with
   one cell changed. The expected result of a test follows from the verdicts at each instant by
   the rules of docs/language.md, which this file implements independently. *)

open Fuzz

let ( / ) = Filename.concat
let programs_each = 3

(* {1 Results of the interpreter} *)

type expected = { fate : string; at : float; by : string }

let rate = 50

(* The instants of a test of this duration. *)
let without_input seconds =
  let row k = (Int.div (k * 1_000_000_000) rate, Interp.Value.Tuple [||]) in
  Recording.make (Tuple [])
    (List.init (1 + int_of_float ((seconds *. float_of_int rate) +. 0.5)) row)

let rows trace =
  List.map (String.split_on_char ',') (List.tl (String.split_on_char '\n' (String.trim trace)))

(* The cells of a row: the time, the judge's verdict, and the claims' verdicts. *)
let expected (observer : Trying.observer) trace =
  let cells row = match row with _ :: judge :: claims -> (judge, claims) | _ -> failwith trace in
  let time row = float_of_string (List.hd row) in
  let failed row =
    let judge, claims = cells row in
    let of_word word =
      List.find_opt
        (fun ((w, _, _), cell) -> w = word && cell = "Fails")
        (List.combine observer.claims claims)
    in
    match (of_word "assume", of_word "assert") with
    | Some ((_, label, _), _), _ -> Some { fate = "void"; at = time row; by = label }
    | None, Some ((_, label, _), _) -> Some { fate = "violated"; at = time row; by = label }
    | None, None when judge = "Fails" -> Some { fate = "violated"; at = time row; by = "judge" }
    | None, None -> None
  in
  let rows = rows trace in
  let last = List.nth rows (List.length rows - 1) in
  match List.find_map failed rows with
  | Some found -> found
  | None when fst (cells last) = "Open" -> { fate = "undecided"; at = time last; by = "judge" }
  | None ->
      let is_asked row =
        let judge, claims = cells row in
        List.exists (fun cell -> cell <> "NotAsked") (judge :: claims)
      in
      { fate = (if List.exists is_asked rows then "held" else "unasked"); at = time last; by = "" }

(* {1 Results of frobc test} *)

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

(* Runs `frobc test` and returns its output, one JSON object a line. *)
let tested frobc file ~jobs =
  let command =
    Printf.sprintf "%s test %s --json --jobs %d --keep kept > verdicts.json 2> verdicts.txt"
      (Filename.quote frobc) file jobs
  in
  match Sys.command command with
  | 0 | 1 -> read "verdicts.json"
  | status -> failwith (Printf.sprintf "%s: status %d\n%s" command status (read "verdicts.txt"))

(* The value of a key in a line with a JSON object, as written. *)
let field key line =
  let pattern = Str.regexp (Printf.sprintf {|"%s":\("[^"]*"\|[^,}]*\)|} key) in
  match Str.search_forward pattern line 0 with
  | _ -> Some (Str.global_replace (Str.regexp_string "\"") "" (Str.matched_group 1 line))
  | exception Not_found -> None

(* {1 Comparison} *)

let failed = ref 0

let report ~text format =
  Printf.ksprintf
    (fun what ->
      incr failed;
      if !failed <= 3 then Printf.printf "FAIL %s\nIt was:\n%s\n" what text)
    format

let golden label file = Printf.sprintf "test %S = trace \"in.csv\" %S\n" label file

(* Changes the last cell of a trace. *)
let changed trace =
  let end_ = String.length trace - 1 in
  let at =
    1 + max (String.rindex_from trace (end_ - 1) ',') (String.rindex_from trace (end_ - 1) '\n')
  in
  String.sub trace 0 at ^ "changed\n"

type count = { mutable tests : int; mutable fates : (string * int) list }

let note counts fate =
  counts.tests <- counts.tests + 1;
  let so_far = Option.value (List.assoc_opt fate counts.fates) ~default:0 in
  counts.fates <- (fate, so_far + 1) :: List.remove_assoc fate counts.fates

let subject tools ~entry file =
  match Engines.load tools ~entry file with
  | Ok subject -> subject
  | Error outcome -> failwith (Printf.sprintf "`%s` %s" entry (Engines.describe outcome))

let one counts frobc tools ~seed k =
  let first = k * programs_each in
  let text, observers = Program.observed ~seed ~first ~count:programs_each in
  let text = text ^ golden "as it is" "is.csv" ^ golden "as it is not" "not.csv" in
  let file = Printf.sprintf "verdicts%d.frob" k in
  write file text;
  let input =
    Engines.recordings
      (Random.State.make [| seed; k; 7 |])
      ~rows:12
      (subject tools ~entry:"main" file)
  in
  let trace = Engines.interpreted (subject tools ~entry:"main" file) (List.hd input) in
  write "in.csv" (Recording.csv (List.hd input));
  write "is.csv" trace;
  write "not.csv" (changed trace);
  let said = tested frobc file ~jobs:1 in
  if not (String.equal said (tested frobc file ~jobs:2)) then
    report ~text "%s: two workers say another thing" file;
  let lines = List.filter (fun line -> line <> "") (String.split_on_char '\n' said) in
  let line label =
    match List.find_opt (fun line -> field "label" line = Some label) lines with
    | Some line -> line
    | None -> failwith (Printf.sprintf "%s: nothing is said of `%s`\n%s" file label said)
  in
  let of_observer (entry, (observer : Trying.observer)) =
    let trace = Engines.interpreted (subject tools ~entry file) (without_input observer.seconds) in
    let expected = expected observer trace and line = line observer.label in
    note counts expected.fate;
    let is key value = field key line = Some value in
    let at = Option.bind (field "at" line) float_of_string_opt in
    if not (is "fate" expected.fate && is "by" expected.by && at = Some expected.at) then
      report ~text "%s: the interpreter has %s at %g by `%s`, and frobc says:\n%s" file
        expected.fate expected.at expected.by line
  in
  List.iter of_observer observers;
  List.iter
    (fun (label, ok) ->
      note counts "golden";
      if field "ok" (line label) <> Some ok then report ~text "%s: %s" file (line label))
    [ ("as it is", "true"); ("as it is not", "false") ];
  Sys.remove file

(* Tests each module in a folder of its own. *)
let () =
  let argument k = Sys.argv.(k) in
  let absolute path = if Filename.is_relative path then Sys.getcwd () / path else path in
  let frobc = absolute (argument 1) in
  let tools =
    {
      Engines.library = absolute (argument 2);
      runtime = absolute (argument 3);
      folder = "work";
      real = Double;
      probed = false;
    }
  in
  let modules = int_of_string (argument 4) and seed = int_of_string (argument 5) in
  let folder = Filename.get_temp_dir_name () / Printf.sprintf "frob-verdicts-%d" (Unix.getpid ()) in
  Unix.mkdir folder 0o700;
  at_exit (fun () -> ignore (Sys.command ("rm -r " ^ Filename.quote folder) : int));
  Sys.chdir folder;
  Unix.mkdir "work" 0o700;
  let counts = { tests = 0; fates = [] } in
  List.iter (one counts frobc tools ~seed) (List.init modules Fun.id);
  let all = [ "held"; "violated"; "undecided"; "unasked"; "void"; "golden" ] in
  let count fate = Option.value (List.assoc_opt fate counts.fates) ~default:0 in
  let missing = List.filter (fun fate -> count fate = 0) all in
  List.iter (Printf.printf "FAIL no test is %s\n") missing;
  Printf.printf "%s %d tests of random programs of seed %d (%s): %d judged otherwise by frobc\n"
    (if !failed = 0 && missing = [] then "ok  " else "FAIL")
    counts.tests seed
    (String.concat ", " (List.map (fun fate -> Printf.sprintf "%d %s" (count fate) fate) all))
    !failed;
  if !failed > 0 || missing <> [] then exit 1
