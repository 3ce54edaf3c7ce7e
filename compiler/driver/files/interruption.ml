exception Signal of int

let signals = [ Sys.sigint; Sys.sigterm; Sys.sighup ]

let protect ~finally work =
  let raise_it signal = raise (Signal signal) in
  let set behaviour s = (s, Sys.signal s behaviour) in
  (* A file at the limit of its size is then an error like a full disk. *)
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
      (* Where it is ignored, there is nothing to go on with either. *)
      exit (128 + if signal = Sys.sigint then 2 else 15)
