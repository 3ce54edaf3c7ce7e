type failure = Not_found of string | Failed of { status : int; errors : string }

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

let read_all channel =
  let text = Buffer.create 1024 and chunk = Bytes.create 1024 in
  let rec go () =
    match input channel chunk 0 1024 with
    | 0 -> Buffer.contents text
    | n ->
        Buffer.add_subbytes text chunk 0 n;
        go ()
  in
  go ()

(* Where processes are made by fork, a missing program shows as status 127. *)
let checked program status = if status = 127 then Error (Not_found program) else Ok status

let output program arguments =
  let read, write = Unix.pipe ~cloexec:true () in
  let started = start program arguments ~stdout:write ~stderr:write in
  Unix.close write;
  let channel = Unix.in_channel_of_descr read in
  let text = Fun.protect ~finally:(fun () -> close_in channel) (fun () -> read_all channel) in
  match Result.bind started (fun pid -> checked program (wait pid)) with
  | Ok 0 -> Ok text
  | Ok status -> Error (Failed { status; errors = text })
  | Error failure -> Error failure

let run program arguments = Result.map ignore (output program arguments)

let hand_over program arguments =
  flush_all ();
  Result.bind (start program arguments ~stdout:Unix.stdout ~stderr:Unix.stderr) (fun pid ->
      checked program (wait pid))

let become program arguments =
  flush_all ();
  try Unix.execvp program (Array.of_list (program :: arguments))
  with Unix.Unix_error _ -> Not_found program
