type result = { status : int; output : string; errors : string }

let processors () =
  match Process.result "getconf" [ "_NPROCESSORS_ONLN" ] with
  | Ok text -> Option.value (int_of_string_opt (String.trim text)) ~default:1
  | Error _ -> 1

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

(* Redirects the program's output to files, so that the program never waits for a reader. *)
let start folder number (program, arguments) =
  let path extension = Filename.concat folder (string_of_int number ^ extension) in
  let opened path = Unix.openfile path [ O_WRONLY; O_CREAT; O_TRUNC; O_CLOEXEC ] 0o600 in
  let output = opened (path ".out") and errors = opened (path ".err") in
  let pid =
    Child.start Ends_with_us program arguments ~stdin:Unix.stdin ~stdout:output ~stderr:errors
  in
  Unix.close output;
  Unix.close errors;
  pid

let rec wait () =
  match Unix.wait () with
  | pid, status -> (pid, Signals.status status)
  | exception Unix.Unix_error (EINTR, _, _) -> wait ()

let run ?(ended = ignore) ~jobs commands =
  let folder = Temporary.folder () in
  let commands = Array.of_list commands in
  let statuses = Array.make (Array.length commands) 0 in
  let running = Hashtbl.create 16 in
  let take () =
    let pid, status = wait () in
    match Hashtbl.find_opt running pid with
    | Some number ->
        statuses.(number) <- status;
        Hashtbl.remove running pid;
        ended number
    | None -> ()
  in
  Array.iteri
    (fun number command ->
      while Hashtbl.length running >= max 1 jobs do
        take ()
      done;
      Hashtbl.replace running (start folder number command) number)
    commands;
  while Hashtbl.length running > 0 do
    take ()
  done;
  let result number status =
    let path extension = Filename.concat folder (string_of_int number ^ extension) in
    { status; output = read (path ".out"); errors = read (path ".err") }
  in
  Array.to_list (Array.mapi result statuses)
