(* As many random programs as wanted, through the interpreter and the compiled
   C. Prints those that fail, and the rate; the exit status is 1 if any did. *)

open Fuzz

type settings = {
  mutable library : string;
  mutable headers : string;
  mutable host : string;
  mutable count : int;
  mutable seed : int;
  mutable first : int;
}

let settings () =
  let s = { library = ""; headers = ""; host = ""; count = 1000; seed = 1; first = 0 } in
  let text name set doc = (name, Arg.String set, doc)
  and number name set doc = (name, Arg.Int set, doc) in
  Arg.parse
    [
      text "--library" (fun v -> s.library <- v) "DIR the standard library";
      text "--headers" (fun v -> s.headers <- v) "DIR holds frob/program.h";
      text "--host" (fun v -> s.host <- v) "FILE the executable frob-trace";
      number "--count" (fun v -> s.count <- v) "N how many programs";
      number "--seed" (fun v -> s.seed <- v) "S another seed gives other programs";
      number "--first" (fun v -> s.first <- v) "N the number of the first program";
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
  if Sys.is_directory path then begin
    Array.iter (fun name -> remove (Filename.concat path name)) (Sys.readdir path);
    Unix.rmdir path
  end
  else Sys.remove path

let () =
  let s = settings () in
  let folder = temporary_folder () in
  at_exit (fun () -> remove folder);
  Unix.putenv "XDG_CACHE_HOME" folder;
  let tools =
    { Engines.library = s.library; headers = s.headers; trace_host = s.host; folder }
  in
  let start = Unix.gettimeofday () in
  let last = s.first + s.count in
  let rec batches first failed =
    if first >= last then failed
    else
      let count = min Batch.size (last - first) in
      let failures = Batch.failures tools ~seed:s.seed ~first ~count in
      List.iter (fun f -> print_endline ("FAIL " ^ Batch.describe ~seed:s.seed f)) failures;
      batches (first + count) (failed + List.length failures)
  in
  let failed = batches s.first 0 in
  let seconds = Unix.gettimeofday () -. start in
  Printf.printf "%d random programs of seed %d: %d failed; %.1f s, %.1f programs a second\n"
    s.count s.seed failed seconds
    (float_of_int s.count /. seconds);
  if failed > 0 then exit 1
