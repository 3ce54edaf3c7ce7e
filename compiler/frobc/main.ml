(* The command line of frobc. What the commands do is in {!Driver};
   here are only their options and texts. *)

open Cmdliner
open Options
module Commands = Driver.Commands
module General = Driver.General

(* {1 Commands} *)

let check =
  command "check" ~doc:"say what is wrong with programs or modules; nothing is written"
    Term.(const Commands.check $ general $ files)

let format =
  let check =
    let doc =
      "Write nothing; print the files that would change, each with its first line that would, and \
       exit with 1 if there are any."
    in
    Arg.(value & flag & info [ "check" ] ~doc)
  in
  let files =
    let doc = "A $(b,.frob) file; $(b,-) is standard input, which goes to standard output." in
    Arg.(non_empty & pos_all string [] & info [] ~docv:"FILE" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Blanks, indentation and empty lines come to be as in the library and the examples. Lines \
         stay where they are broken, and are broken where they have more than 100 characters; what \
         is aligned by blanks stays so. Nothing else changes: each result is checked to be the \
         same program with the same comments. A file that is no program stays as it is.";
    ]
  in
  command "format" ~man ~doc:"write programs as the library is written, in place"
    Term.(const (fun check files -> Driver.Format_files.run ~check files) $ check $ files)

let fix =
  let diff =
    let doc = "Write nothing; print what would change, as $(b,diff -u) does." in
    Arg.(value & flag & info [ "diff" ] ~doc)
  in
  let all =
    let doc =
      "Make all fixes, also those that may not be what you meant; of several for one place the \
       first."
    in
    Arg.(value & flag & info [ "all" ] ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Many messages of the compiler say what to write instead. Where nothing else can have been \
         meant, $(tname) writes it, looks at the program again, and so on, and prints each fix \
         that it made. What is left to do by hand is printed as $(b,frobc check) does.";
      `P "An editor offers all fixes where they belong: see $(b,frobc lsp).";
    ]
  in
  command "fix" ~man ~doc:"mend what messages say how to mend, in place"
    Term.(
      const (fun general diff all files ->
          Driver.Fix_files.(run general ~diff (if all then All else Safe)) files)
      $ general $ diff $ all $ files)

let compile =
  let folder =
    let doc = "The folder for the C files." in
    Arg.(value & opt string "." & info [ "o"; "output" ] ~docv:"DIR" ~doc)
  in
  let batch =
    let doc =
      "With a function NAME_steps that takes many steps in one call, for replay and simulation."
    in
    Arg.(value & flag & info [ "batch" ] ~doc)
  in
  let standalone =
    let doc =
      "Put into the two files what they need of frobc's own headers and sources, so that they \
       compile anywhere by themselves."
    in
    Arg.(value & flag & info [ "standalone" ] ~doc)
  in
  let run general entry batch standalone folder file =
    Commands.compile general entry ~batch ~standalone folder file
  in
  command "compile" ~doc:"translate a program to C: NAME.c and NAME.h"
    Term.(const run $ not_judging general $ entry $ batch $ standalone $ folder $ file)

let build =
  let output =
    let doc = "Where to write it; without it, the program's name." in
    Arg.(value & opt (some string) None & info [ "o"; "output" ] ~docv:"EXE" ~doc)
  in
  let shared =
    let doc =
      "Make a shared object instead, for hosts of this machine that load programs: with the \
       program's table, and a function NAME_steps that takes many steps in one call."
    in
    Arg.(value & flag & info [ "shared" ] ~doc)
  in
  let target =
    let describe name =
      let meaning = Option.fold ~none:"" ~some:Driver.Target.meaning (Driver.Target.of_name name) in
      Printf.sprintf "$(b,%s) (%s)" name meaning
    in
    let doc =
      "The machine to build for: "
      ^ String.concat "; " (List.map describe Driver.Target.names)
      ^ "."
    in
    Arg.(value & opt string "host" & info [ "target" ] ~docv:"TARGET" ~doc)
  in
  command "build" ~doc:"the executable that $(b,run --device) would start"
    Term.(
      const (fun general entry sources target shared output file ->
          if shared && target <> "host" then
            Driver.General.wrong_use "--shared is for this machine, without --target"
          else if shared then Driver.Real_robot.library general ~entry ~sources ~output file
          else Driver.Real_robot.build general ~entry ~sources ~target ~output file)
      $ not_judging general $ entry $ sources $ target $ shared $ output $ file)

let export =
  let folder =
    let doc =
      "Write a library folder for PlatformIO: library.json, the C in $(b,src), and a main program \
       for boards with the Arduino framework in $(b,examples), in a folder of the program's name."
    in
    Arg.(required & opt (some string) None & info [ "platformio" ] ~docv:"DIR" ~doc)
  in
  command "export" ~doc:"a robot program as a library for other build tools"
    Term.(
      const (fun general entry sources folder file ->
          Driver.Export.platformio general ~entry ~sources ~folder file)
      $ general $ entry $ sources $ folder $ file)

let report =
  let states =
    let doc = "Instead of that the switches and tasks as a state diagram, for Graphviz." in
    Arg.(value & flag & info [ "states" ] ~doc)
  in
  command "report" ~doc:"memory, operations and stack of a step, stated before it runs"
    Term.(
      const (fun general entry states file -> Commands.report general ~entry ~states file)
      $ general $ entry $ states $ file)

let header =
  let robot =
    Arg.(
      required
      & pos 0 (some string) None
      & info [] ~docv:"ROBOT"
          ~doc:("The robot: " ^ robot_names ^ ", or the file of the module of one of your own."))
  in
  command "header" ~doc:"the C header with a robot's input and output types"
    Term.(const Commands.header $ robot)

let selftest =
  let some names ~docv ~doc = Arg.(value & opt (some string) None & info names ~docv ~doc) in
  let cc =
    some [ "cc" ] ~docv:"CC"
      ~doc:
        "The C compiler, a command, perhaps with options. Without it: that of the environment \
         variable $(b,CC), or $(b,cc)."
  in
  let cflags =
    some [ "cflags" ] ~docv:"FLAGS"
      ~doc:
        (Printf.sprintf
           "Its options, separated by spaces, for compiling and for linking. Without them: $(b,%s)."
           (String.concat " " Driver.Toolchain.flags))
  in
  let runner =
    some [ "runner" ] ~docv:"COMMAND"
      ~doc:"What runs the programs that a cross compiler makes, such as $(b,qemu-aarch64)."
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Compiles programs that together have every construct of the C that frobc writes, runs \
         them, and compares their outputs with those of the reference interpreter, bit for bit. \
         Prints a line for each of them and the verdict. What is wrong is said on standard error: \
         numbers that are not IEEE 754's (contraction, $(b,-ffast-math), other rounding), code \
         that does not compile, outputs that differ, and what the compiler warns of.";
      `P
        "The exit status is 0 if the compiler is fit, 1 if it is not, and 2 if it could not be \
         tried.";
      `P
        "A compiler for another machine needs an emulator that runs its programs, one for a board \
         also a library that prints through it:";
      `Pre
        "frobc selftest --cc aarch64-linux-gnu-gcc \\\\\n\
        \  --cflags \"-O2 -ffp-contract=off -static\" --runner qemu-aarch64\n\
         frobc selftest --cc arm-none-eabi-gcc \\\\\n\
        \  --cflags \"-O2 -ffp-contract=off --specs=rdimon.specs\" --runner qemu-arm";
    ]
  in
  command "selftest" ~man ~doc:"whether a C compiler, with its options, is fit for generated C"
    Term.(
      const (fun cc cflags runner real -> Driver.Selftest.run { cc; cflags; runner; real })
      $ cc $ cflags $ runner $ real)

let new_project =
  let folder =
    let doc =
      "The folder to make, as in $(b,rover) or $(b,robots/rover): letters, digits, $(b,_) and \
       $(b,-). The program in it is called so too."
    in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"NAME" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Makes a project to begin with: a program that drives about and touches nothing, with \
         trials that say so; a world; a README with the commands that there are; and what editors \
         are to know. A folder that is there already stays as it is.";
    ]
  in
  command "new" ~man ~doc:"a folder with a program, its world and its trials, to begin with"
    Term.(const Driver.New_project.run $ folder)

let explain =
  let code =
    Arg.(
      required
      & pos 0 (some string) None
      & info [] ~docv:"CODE" ~doc:"The code of a diagnostic, such as $(b,E0401).")
  in
  command "explain" ~doc:"what a diagnostic means, with an example and its cure"
    Term.(const Commands.explain $ code)

let lsp =
  let stdio =
    let doc = "Standard input and output, as without it: some editors say so." in
    Arg.(value & flag & info [ "stdio" ] ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "An editor starts this and asks it about programs: messages while you type, types, \
         definitions, completion, renaming, and so on, by the Language Server Protocol. How to set \
         up an editor is told in docs/editors.md.";
    ]
  in
  command "lsp" ~man ~doc:"the compiler in an editor"
    Term.(const (fun (_ : bool) -> Language_server.Server.run ()) $ stdio)

let help names =
  let topic =
    let doc = "The command; without it, frobc as a whole." in
    Arg.(value & pos 0 (some string) None & info [] ~docv:"COMMAND" ~doc)
  in
  let show = function
    | Some name when not (List.mem name names) ->
        `Error
          ( false,
            Printf.sprintf "there is no command `%s`; the commands are %s" name
              (String.concat ", " names) )
    | topic -> `Help (`Auto, topic)
  in
  command "help" ~doc:"what a command does, and its options" Term.(ret (const show $ topic))

let commands =
  let all =
    [
      new_project;
      check;
      fix;
      format;
      compile;
      Running.trace;
      Running.run;
      Trying.test;
      Trying.sweep;
      Falsifying.falsify;
      Running.view;
      Converting.convert;
      Running.serve;
      build;
      export;
      report;
      selftest;
      header;
      explain;
      lsp;
    ]
  in
  all @ [ help ("help" :: List.map Cmd.name all) ]

let main =
  let doc = "compiler for Frob, a language for programming mobile robots" in
  let man =
    [
      `S Manpage.s_description;
      `P
        "In Frob time is implicit and behaviour is written as equations. $(tname) type-checks a \
         program and turns it into C: no heap, no recursion, memory and time known in advance.";
      `P
        "$(b,frobc new rover) makes a project to begin with. $(b,frobc help COMMAND) tells more of \
         a command, and $(b,frobc explain CODE) of a message.";
      `S Manpage.s_see_also;
      `P
        "The documentation: a tutorial, pages for single jobs, the language, in share/doc/frobc of \
         an installation.";
    ]
  in
  Cmd.group (Cmd.info "frobc" ~version:"0.1" ~doc ~man ~exits) commands

(* A compilation is short, and what outlives the minor heap mostly lives to the
   end: marking finds little to free. Without it large programs take a tenth less
   work (and 0.6 GB for 100,000 lines; to free the front end's trees when only Flow is
   wanted would make that 0.5 GB, and take more time than it saves). In a small heap there
   would be marking all the same, as it is done in proportion to what share of the
   heap is new: so the heap grows by 32 MB at a time, of which only what is used is
   real memory. Where hardly anything is freed there is no use in looking for the
   block that fits best (policy 2, the default) either: policy 0 takes the next one;
   nor in moving blocks together (never, with so large an overhead). Nor does the
   buffer of each file that was read ask for marking (the ratio of such memory).
   The minor heap stays as it is: a larger one leaves the processor's cache. *)
let collect_seldom () =
  Gc.set
    {
      (Gc.get ()) with
      space_overhead = 10_000;
      max_overhead = 1_000_000;
      major_heap_increment = 4 * 1024 * 1024;
      allocation_policy = 0;
      custom_major_ratio = 1_000_000;
    }

(* The flags of a C compiler begin as options do: `--cflags -O2`. *)
let rec with_flags = function
  | "--cflags" :: flags :: rest -> ("--cflags=" ^ flags) :: with_flags rest
  | argument :: rest -> argument :: with_flags rest
  | [] -> []

let argv = Array.of_list (with_flags (Array.to_list Sys.argv))

let () =
  collect_seldom ();
  Driver.Streams.keep_numbers ();
  let status =
    match Cmd.eval_value ~catch:false ~argv main with
    | Ok (`Ok status) -> status
    | Ok (`Version | `Help) -> Driver.Exit_status.ok
    | Error (`Parse | `Term) -> Driver.Exit_status.wrong_use
    | Error `Exn -> Driver.Exit_status.bug
    | exception exn when Driver.Streams.output_fault () = None -> General.report_exception exn
    | exception _ -> Driver.Exit_status.wrong_use
  in
  let status =
    match Driver.Streams.output_fault () with
    | None -> status
    | Some reason ->
        Printf.eprintf "error: cannot write standard output: %s\n" reason;
        if status = Driver.Exit_status.ok then Driver.Exit_status.wrong_use else status
  in
  Driver.Streams.drop_unwritable ();
  exit status
