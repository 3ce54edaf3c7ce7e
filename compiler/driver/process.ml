type failure =
  | Not_found of string
  | Failed of { status : int; errors : string }

let rec wait pid =
  match Unix.waitpid [] pid with
  | _, Unix.WEXITED status -> status
  | _, (Unix.WSIGNALED signal | Unix.WSTOPPED signal) -> 128 + signal
  | exception Unix.Unix_error (Unix.EINTR, _, _) -> wait pid

let start program arguments ~stdout ~stderr =
  match
    Unix.create_process program (Array.of_list (program :: arguments)) Unix.stdin stdout stderr
  with
  | pid -> Ok pid
  | exception Unix.Unix_error ((Unix.ENOENT | Unix.EACCES), _, _) -> Error (Not_found program)
  (* such as ENOEXEC, of a program for another machine; the status is a shell's *)
  | exception Unix.Unix_error (reason, _, _) ->
      Error (Failed { status = 126; errors = Unix.error_message reason })

(* Where processes are made by fork, a missing program shows as status 127. *)
let checked program status = if status = 127 then Error (Not_found program) else Ok status

let read_all path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let output program arguments =
  let log = Filename.temp_file "frobc" ".log" in
  Fun.protect
    ~finally:(fun () -> Sys.remove log)
    (fun () ->
      let channel = Unix.openfile log [ Unix.O_WRONLY; Unix.O_TRUNC ] 0o600 in
      let started = start program arguments ~stdout:channel ~stderr:channel in
      Unix.close channel;
      match Result.bind started (fun pid -> checked program (wait pid)) with
      | Ok 0 -> Ok (read_all log)
      | Ok status -> Error (Failed { status; errors = read_all log })
      | Error failure -> Error failure)

let run program arguments = Result.map ignore (output program arguments)

let hand_over program arguments =
  flush_all ();
  Result.bind
    (start program arguments ~stdout:Unix.stdout ~stderr:Unix.stderr)
    (fun pid -> checked program (wait pid))

let become program arguments =
  flush_all ();
  try Unix.execv program (Array.of_list (program :: arguments))
  with Unix.Unix_error _ -> Not_found program
