external number : int -> int = "frobc_child_signal_number" [@@noalloc]

let status = function
  | Unix.WEXITED status -> status
  | Unix.WSIGNALED signal | Unix.WSTOPPED signal -> 128 + number signal

(* The signals that end a process, with OCaml's signal numbers. *)
let names =
  [
    ("SIGABRT", Sys.sigabrt);
    ("SIGALRM", Sys.sigalrm);
    ("SIGBUS", Sys.sigbus);
    ("SIGFPE", Sys.sigfpe);
    ("SIGHUP", Sys.sighup);
    ("SIGILL", Sys.sigill);
    ("SIGINT", Sys.sigint);
    ("SIGKILL", Sys.sigkill);
    ("SIGPIPE", Sys.sigpipe);
    ("SIGPROF", Sys.sigprof);
    ("SIGQUIT", Sys.sigquit);
    ("SIGSEGV", Sys.sigsegv);
    ("SIGSYS", Sys.sigsys);
    ("SIGTERM", Sys.sigterm);
    ("SIGTRAP", Sys.sigtrap);
    ("SIGUSR1", Sys.sigusr1);
    ("SIGUSR2", Sys.sigusr2);
    ("SIGVTALRM", Sys.sigvtalrm);
    ("SIGXCPU", Sys.sigxcpu);
    ("SIGXFSZ", Sys.sigxfsz);
  ]

let name status =
  let is_it (_, signal) = 128 + number signal = status in
  match List.find_opt is_it names with
  | Some (name, _) -> Some name
  | None when status > 128 -> Some (Printf.sprintf "signal %d" (status - 128))
  | None -> None
