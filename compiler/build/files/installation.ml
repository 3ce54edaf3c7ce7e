open Resources

let ( / ) = Filename.concat

let under prefix =
  {
    prefix;
    library = prefix / "share" / "frobc" / "stdlib";
    headers = prefix / "share" / "frobc" / "include";
    runtime = prefix / "lib" / "frobc" / "libfrob.a";
    robot_host = prefix / "lib" / "frobc" / "libfrob-robot.a";
    runtime_sources = prefix / "share" / "frobc" / "runtime";
    elementary = prefix / "share" / "frobc" / "elementary";
    own_compiler = prefix / "lib" / "frobc" / "frob-tcc";
    trace_host = prefix / "lib" / "frobc" / "frob-trace";
    viewer = prefix / "lib" / "frobc" / "frob-view";
    simulator = prefix / "lib" / "frobc" / "frob-sim";
    server = prefix / "lib" / "frobc" / "frob-serve";
    worlds = prefix / "share" / "frobc" / "worlds";
    selftest = prefix / "share" / "frobc" / "selftest";
    template = prefix / "share" / "frobc" / "template";
    demo = prefix / "share" / "frobc" / "demo";
    python = prefix / "share" / "frobc" / "python";
  }

let is_complete t = Sys.file_exists (t.library / "Prelude.frob")

(* The operating system resolves symbolic links in the executable's path. During a build, the
   executable is therefore found in _build/default/compiler/frobc, not in the installation elsewhere
   in _build. *)
let candidates () =
  let folder = Filename.dirname Sys.executable_name in
  let build = Filename.dirname (Filename.dirname (Filename.dirname folder)) in
  let home =
    match Sys.getenv_opt "FROB_HOME" with Some home when home <> "" -> [ home ] | _ -> []
  in
  home @ [ Filename.dirname folder; build / "install" / "default" ]

let find () =
  match List.find_opt is_complete (List.map under (candidates ())) with
  | Some t -> Ok t
  | None ->
      Error
        (Printf.sprintf
           "frobc cannot find its standard library (it looked for share/frobc/stdlib in %s); \
            install it with `make install`, or set FROB_HOME to the folder that it is installed in"
           (String.concat ", " (candidates ())))
