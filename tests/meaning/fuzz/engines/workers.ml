let ( / ) = Filename.concat

let start ~folder work i =
  let own = folder / string_of_int i in
  Unix.mkdir own 0o700;
  let result = own / "result" in
  flush_all ();
  match Unix.fork () with
  | 0 ->
      List.iter (fun signal -> Sys.set_signal signal Sys.Signal_default) [ Sys.sigint; Sys.sigterm ];
      let status =
        match work i ~folder:own with
        | answer ->
            let channel = open_out_bin result in
            Marshal.to_channel channel answer [];
            close_out channel;
            0
        | exception exn ->
            prerr_endline (Printexc.to_string exn);
            1
      in
      (* Not [exit]: at_exit functions are for the parent. *)
      flush_all ();
      Unix._exit status
  | pid -> (pid, result)

let answer result (status : Unix.process_status) =
  match status with
  | WEXITED 0 ->
      let channel = open_in_bin result in
      Fun.protect
        ~finally:(fun () -> close_in channel)
        (fun () -> Ok (Marshal.from_channel channel))
  | WEXITED status -> Error (Printf.sprintf "a process ended with status %d" status)
  | WSIGNALED signal | WSTOPPED signal ->
      Error (Printf.sprintf "a process was ended by signal %d" signal)

(* The process may already have ended, for example because all of them received a signal. *)
let end_process (pid, _) =
  try
    Unix.kill pid Sys.sigkill;
    ignore (Unix.waitpid [] pid : int * Unix.process_status)
  with Unix.Unix_error ((ESRCH | ECHILD), _, _) -> ()

let run ~jobs ~folder ~enough work =
  let running = ref (List.init jobs (start ~folder work)) in
  let end_all () =
    let all = !running in
    running := [];
    List.iter end_process all
  in
  at_exit end_all;
  let rec collect answers =
    if !running = [] then answers
    else
      let pid, status = Unix.wait () in
      match List.partition (fun (other, _) -> other = pid) !running with
      | [ (_, result) ], others -> (
          running := others;
          match answer result status with
          | Ok value as answer when enough value ->
              end_all ();
              answer :: answers
          | answer -> collect (answer :: answers))
      | _, _ -> collect answers
  in
  collect []
