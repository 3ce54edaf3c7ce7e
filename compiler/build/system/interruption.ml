exception Signal of int

let signals = [ Sys.sigint; Sys.sigterm; Sys.sighup ]

let reported report work =
  let before = Sys.signal Sys.sigint (Signal_handle (fun signal -> raise (Signal signal))) in
  let finally () = Sys.set_signal Sys.sigint before in
  match Fun.protect ~finally work with
  | result -> result
  | exception (Signal signal | Fun.Finally_raised (Signal signal)) ->
      Sys.set_signal Sys.sigint Signal_ignore;
      Terminal.clear ();
      Printf.eprintf "interrupted: %s\n%!" (report ());
      flush_all ();
      Sys.set_signal signal Signal_default;
      Unix.kill (Unix.getpid ()) signal;
      exit 130

let protect ~finally work =
  let raise_it signal = raise (Signal signal) in
  let set behaviour s = (s, Sys.signal s behaviour) in
  (* With SIGXFSZ ignored, writing a file that is too large returns an error, as on a full disk. *)
  let before =
    set Sys.Signal_ignore Sys.sigxfsz :: List.map (set (Sys.Signal_handle raise_it)) signals
  in
  let restore () = List.iter (fun (s, behaviour) -> Sys.set_signal s behaviour) before in
  let finally () =
    restore ();
    finally ()
  in
  match Fun.protect ~finally work with
  | result -> result
  | exception Signal signal ->
      Unix.kill (Unix.getpid ()) signal;
      (* If the signal is ignored, the process exits here, because it cannot continue. *)
      exit (128 + if signal = Sys.sigint then 2 else if signal = Sys.sighup then 1 else 15)
