let ( / ) = Filename.concat

let start ~folder work i =
  let own = folder / string_of_int i in
  Unix.mkdir own 0o700;
  let result = own / "result" in
  flush_all ();
  match Unix.fork () with
  | 0 ->
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
      (* Not [exit]: what is to be done at the end is the parent's to do. *)
      flush_all ();
      Unix._exit status
  | pid -> (pid, result)

let answer (pid, result) =
  match Unix.waitpid [] pid with
  | _, WEXITED 0 ->
      let channel = open_in_bin result in
      Fun.protect
        ~finally:(fun () -> close_in channel)
        (fun () -> Ok (Marshal.from_channel channel))
  | _, WEXITED status -> Error (Printf.sprintf "a process ended with status %d" status)
  | _, (WSIGNALED signal | WSTOPPED signal) ->
      Error (Printf.sprintf "a process was ended by signal %d" signal)

let run ~jobs ~folder work =
  let started = List.init jobs (start ~folder work) in
  List.map answer started
