open Basis.Let_syntax.Result

type run = { place : Setup.place; point : string array; seed : int; key : string }

let seeds (t : Setup.t) = t.last - t.first + 1
let count (t : Setup.t) = Array.length t.places * Array.length t.points * seeds t

let key (t : Setup.t) (place : Setup.place) point seed =
  let settings = List.mapi (fun k (axis : Points.axis) -> axis.name ^ "=" ^ point.(k)) t.axes in
  Printf.sprintf "%s %.9g %.9g %d %s" (Digest.to_hex place.digest) t.lasts t.rate seed
    (String.concat " " settings)
  |> Digest.string |> Digest.to_hex

let run (t : Setup.t) number =
  let points = Array.length t.points and seeds = seeds t in
  let place = t.places.(number / (points * seeds)) in
  let point = t.points.(number / seeds mod points) in
  let seed = t.first + (number mod seeds) in
  { place; point; seed; key = key t place point seed }

type shard = { number : int; of_ : int }

let missing t shard rows =
  let rec from number found =
    if number < 0 then found
    else
      let is_ours = number mod shard.of_ = shard.number - 1 in
      let lacks = is_ours && Option.is_none (Rows.find rows (run t number).key) in
      from (number - 1) (if lacks then number :: found else found)
  in
  from (count t - 1) []

(* {1 Making runs} *)

(* Splits runs into parts, each for one process. All runs of a part have the same world and robot.
   Parts are small enough that the processes finish at about the same time. *)
let most_in_part = 200

let parts (t : Setup.t) ~jobs numbers =
  let total = List.length numbers in
  let size = max 1 (min most_in_part (total / (jobs * 4))) in
  let place number = number / (Array.length t.points * seeds t) in
  let add parts number =
    match parts with
    | (first :: _ as part) :: others when List.length part < size && place first = place number ->
        (number :: part) :: others
    | _ -> [ number ] :: parts
  in
  List.rev_map List.rev (List.fold_left add [] numbers)

type process = { numbers : int list; rows_file : string; errors : string; mutable seen : int }

let start (t : Setup.t) (resources : Resources.t) ~folder numbers =
  let scratch = Temporary.folder () in
  let list = Filename.concat scratch "runs" and errors = Filename.concat scratch "errors" in
  let line number =
    let { point; seed; key; _ } = run t number in
    let setting k (axis : Points.axis) = axis.name ^ "=" ^ point.(k) in
    String.concat "\t" (key :: string_of_int seed :: List.mapi setting t.axes) ^ "\n"
  in
  let* () = Output.write [ (list, String.concat "" (List.map line numbers)) ] in
  let place = (run t (List.hd numbers)).place in
  let arguments =
    [
      place.program;
      "--world";
      place.path;
      "--judge";
      place.judge;
      "--for";
      Printf.sprintf "%.9f" t.lasts;
      "--rate";
      Printf.sprintf "%.9g" t.rate;
      "--runs";
      list;
    ]
  in
  let rows_file, rows = Rows.fresh folder in
  let complaints = Unix.openfile errors [ O_WRONLY; O_CREAT; O_EXCL; O_CLOEXEC ] 0o644 in
  let pid =
    Child.start Ends_with_us resources.simulator arguments ~stdin:Unix.stdin ~stdout:rows
      ~stderr:complaints
  in
  Unix.close rows;
  Unix.close complaints;
  Ok (pid, { numbers; rows_file; errors; seen = 0 })

(* The number of lines that the process has written since the last call. *)
let more process =
  let channel = open_in_bin process.rows_file in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () ->
      seek_in channel process.seen;
      let size = in_channel_length channel - process.seen in
      let text = really_input_string channel size in
      process.seen <- process.seen + size;
      List.length (String.split_on_char '\n' text) - 1)

let complaint process =
  let text = String.trim (Checking.read process.errors) in
  let line = List.hd (String.split_on_char '\n' text) in
  let prefix = "error: " in
  if String.starts_with ~prefix line then
    String.sub line (String.length prefix) (String.length line - String.length prefix)
  else if line <> "" then line
  else "a run failed to start"

let most_failures = 20
let between_looks = 0.02

let make t resources ~jobs ~folder rows numbers =
  let waiting = Queue.of_seq (List.to_seq (parts t ~jobs numbers)) in
  let running = Hashtbl.create 16 and failures = ref 0 and stopped = ref None in
  let progress = Progress.start t.label ~total:(List.length numbers) in
  let look () = Hashtbl.iter (fun _ process -> Progress.add progress (more process)) running in
  let ended pid status =
    match Hashtbl.find_opt running pid with
    | None -> ()
    | Some process ->
        Progress.add progress (more process);
        Hashtbl.remove running pid;
        Rows.load_file rows process.rows_file;
        let is_missing number = Option.is_none (Rows.find rows (run t number).key) in
        let left = List.filter is_missing process.numbers in
        (match (status : Unix.process_status) with
        | WEXITED 0 -> ()
        | WEXITED _ -> if !stopped = None then stopped := Some (complaint process)
        | WSIGNALED _ | WSTOPPED _ ->
            if List.compare_lengths left process.numbers = 0 then incr failures;
            if !failures > most_failures then
              stopped :=
                Some
                  "the system keeps killing processes, perhaps for lack of memory: use fewer of \
                   them (`--jobs`)");
        if left <> [] then Queue.add left waiting
  in
  let rec go () =
    while !stopped = None && Hashtbl.length running < jobs && not (Queue.is_empty waiting) do
      match start t resources ~folder (Queue.pop waiting) with
      | Ok (pid, process) -> Hashtbl.replace running pid process
      | Error reason -> stopped := Some reason
      | exception Unix.Unix_error (reason, _, what) ->
          stopped := Some (Printf.sprintf "%s: %s" what (Unix.error_message reason))
    done;
    if Hashtbl.length running > 0 then (
      (match Unix.waitpid [ WNOHANG ] (-1) with
      | 0, _ ->
          look ();
          Unix.sleepf between_looks
      | pid, status -> ended pid status
      | exception Unix.Unix_error (EINTR, _, _) -> ());
      go ())
  in
  go ();
  Progress.finish progress;
  match !stopped with Some reason -> Error reason | None -> Ok ()
