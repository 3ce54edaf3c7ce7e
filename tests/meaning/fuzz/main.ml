(* Runs random programs in the interpreter and as compiled C. Prints those that fail, then a line
   with their number and the rate; the exit status is 1 if any failed.

   Other tools start this program: do not change the meaning of `--count`, `--seed`,
   `--stop-at-first` and the exit status. When run from the repository's root, it needs no other
   arguments. *)

open Fuzz

type settings = {
  mutable library : string;
  mutable runtime : string;
  mutable count : int;
  mutable seed : int;
  mutable first : int;
  mutable jobs : int;
  mutable sanitize_every : int;
  mutable stop_at_first : bool;
  mutable all_constructs : bool;
  mutable real : string;
}

let settings () =
  let s =
    {
      library = "stdlib";
      runtime = "runtime";
      count = 1000;
      seed = 1;
      first = 0;
      jobs = 1;
      sanitize_every = 0;
      stop_at_first = false;
      all_constructs = false;
      real = "both";
    }
  in
  let text name set doc = (name, Arg.String set, doc)
  and number name set doc = (name, Arg.Int set, doc) in
  Arg.parse
    [
      number "--count" (fun v -> s.count <- v) "N how many programs (1000)";
      number "--seed" (fun v -> s.seed <- v) "S another seed gives other programs (1)";
      number "--first" (fun v -> s.first <- v) "N the number of the first program (0)";
      ( "--stop-at-first",
        Arg.Unit (fun () -> s.stop_at_first <- true),
        " end at the first batch of programs with one that fails, and show only that it does" );
      ( "--all-constructs",
        Arg.Unit (fun () -> s.all_constructs <- true),
        " fail also if a construct of the language is never generated" );
      number "--jobs" (fun v -> s.jobs <- v) "N how many processes at once (1)";
      number "--sanitize-every"
        (fun v -> s.sanitize_every <- v)
        "N every so many batches one goes through gcc or clang as well, with sanitizers (0: none)";
      ( "--real",
        Arg.Symbol ([ "double"; "float"; "both" ], fun v -> s.real <- v),
        " what the programs compute with; both: one batch in three with float (both)" );
      text "--library" (fun v -> s.library <- v) "DIR the standard library (stdlib)";
      text "--runtime" (fun v -> s.runtime <- v) "DIR the runtime's sources (runtime)";
    ]
    (fun other -> raise (Arg.Bad ("what is " ^ other ^ "?")))
    "random programs through the interpreter and the compiled C";
  s

let temporary_folder () =
  let path =
    Filename.concat (Filename.get_temp_dir_name ()) (Printf.sprintf "frob-fuzz-%d" (Unix.getpid ()))
  in
  Unix.mkdir path 0o700;
  path

let rec remove path =
  if Sys.is_directory path then (
    Array.iter (fun name -> remove (Filename.concat path name)) (Sys.readdir path);
    Unix.rmdir path)
  else Sys.remove path

(* Alternates gcc and clang. *)
let engines s batch : Engines.c_engine list =
  if s.sanitize_every = 0 || batch mod s.sanitize_every <> s.sanitize_every - 1 then [ Tcc ]
  else
    let turn = batch / s.sanitize_every mod 2 in
    [ Tcc; Sanitized (if turn = 0 then Gcc else Clang) ]

(* Alternates the precision, so that each kind of program is tested with both. *)
let real s batch : Basis.Real.t =
  match s.real with
  | "double" -> Double
  | "float" -> Single
  | _ -> if (batch + (batch / Bias.count)) mod 3 = 1 then Single else Double

(* Probes one batch in five, and each kind of program. *)
let probed batch = (batch + (batch / Bias.count)) mod 5 = 2

type result = { programs : int; failed : int; sanitized : int; seen : Coverage.t }

let nothing () = { programs = 0; failed = 0; sanitized = 0; seen = Coverage.create () }

let both a b =
  Coverage.add a.seen b.seen;
  {
    a with
    programs = a.programs + b.programs;
    failed = a.failed + b.failed;
    sanitized = a.sanitized + b.sanitized;
  }

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let most_shrunk = 3

(* The work of a worker: every [jobs]-th batch, starting with the worker's number. *)
let work s worker ~folder =
  let last = s.first + s.count in
  let rec batches batch so_far =
    let first = s.first + (batch * Batch.size) in
    if first >= last || (s.stop_at_first && so_far.failed > 0) then so_far
    else
      let count = min Batch.size (last - first) in
      let engines = engines s batch in
      let tools =
        {
          Engines.library = s.library;
          runtime = s.runtime;
          folder;
          real = real s batch;
          probed = probed batch;
        }
      in
      let seen = Coverage.create () in
      let failures =
        if s.stop_at_first then
          Option.to_list (Batch.first_failure ~seen tools engines ~seed:s.seed ~first ~count)
        else Batch.failures ~seen tools engines ~seed:s.seed ~first ~count
      in
      (* A few small failing programs are more useful than many. *)
      let shrunk k f =
        if s.stop_at_first || so_far.failed + k >= most_shrunk then f
        else Batch.shrunk tools engines ~seed:s.seed f
      in
      List.iteri
        (fun k f ->
          let f = shrunk k f in
          print_endline
            ("FAIL " ^ (if s.stop_at_first then Batch.summary else Batch.describe) ~seed:s.seed f))
        failures;
      let sanitized = if List.length engines > 1 then count else 0 in
      batches (batch + s.jobs)
        (both so_far { programs = count; failed = List.length failures; sanitized; seen })
  in
  batches worker (nothing ())

let () =
  let s = settings () in
  (* There are many short-lived values; a large minor heap saves most of the garbage collector's
     work. *)
  Gc.set
    {
      (Gc.get ()) with
      minor_heap_size = 1_000_000;
      space_overhead = 1000;
      max_overhead = 1_000_000;
    };
  (* Sanitized programs run in a short-lived process, where memory still allocated at the end is
     not a leak. *)
  Unix.putenv "ASAN_OPTIONS" "detect_leaks=0";
  let folder = temporary_folder () in
  at_exit (fun () -> remove folder);
  let leave = Sys.Signal_handle (fun _ -> exit 1) in
  List.iter (fun signal -> Sys.set_signal signal leave) [ Sys.sigint; Sys.sigterm ];
  let start = Unix.gettimeofday () in
  let enough r = s.stop_at_first && r.failed > 0 in
  let results = Workers.run ~jobs:s.jobs ~folder ~enough (work s) in
  let seconds = Unix.gettimeofday () -. start in
  let broken = List.filter_map (function Error text -> Some text | Ok _ -> None) results in
  List.iter (fun text -> print_endline ("FAIL random programs: " ^ text)) broken;
  let all = List.fold_left both (nothing ()) (List.filter_map Result.to_option results) in
  let prelude = read (Filename.concat s.library "Prelude.frob") in
  if not s.stop_at_first then
    Printf.printf "how often each construct was generated:\n%s\n" (Coverage.text ~prelude all.seen);
  let missing = if s.all_constructs then Coverage.missing ~prelude all.seen else [] in
  List.iter (Printf.printf "FAIL random programs: `%s` is never generated\n") missing;
  let ok = all.failed = 0 && broken = [] && missing = [] in
  Printf.printf
    "%s %d random programs of seed %d, %d of them with sanitizers: %d failed; %.1f s, %.1f \
     programs a second\n"
    (if ok then "ok  " else "FAIL")
    all.programs s.seed all.sanitized all.failed seconds
    (float_of_int all.programs /. seconds);
  if not ok then exit 1
