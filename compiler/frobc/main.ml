(* Defines the command line of frobc: options and help texts. {!Tools} implements the commands. *)

open Cmdliner
open Options
module Commands = Tools.Commands
module Reporting = Build.Reporting

(* {1 Commands} *)

let check =
  command "check" ~doc:"check programs or modules for mistakes without writing any files"
    Term.(const Commands.check $ general $ files)

let format =
  let check =
    let doc =
      "Write nothing. Print the name of each file that would change, with the first line that \
       would change, and exit with status 1 if there are any such files."
    in
    Arg.(value & flag & info [ "check" ] ~doc)
  in
  let files =
    let doc =
      "A $(b,.frob) file. With $(b,-), format standard input and write the result to standard \
       output."
    in
    Arg.(non_empty & pos_all string [] & info [] ~docv:"FILE" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Formats spaces, indentation and empty lines in the style of the library and the examples. \
         $(tname) keeps existing line breaks and columns that are aligned with spaces, and breaks \
         lines of more than 100 characters. Nothing else changes: $(tname) checks that the result \
         is the same program with the same comments. A file with syntax errors is left unchanged.";
    ]
  in
  command "format" ~man ~doc:"format programs in place, in the style of the library"
    Term.(const (fun check files -> Tools.Format_files.run ~check files) $ check $ files)

let fix =
  let diff =
    let doc = "Write nothing; print the changes in the format of $(b,diff -u)." in
    Arg.(value & flag & info [ "diff" ] ~doc)
  in
  let all =
    let doc =
      "Apply all fixes, including those that may not be what you meant. If there are several fixes \
       for one place, apply the first."
    in
    Arg.(value & flag & info [ "all" ] ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Many compiler messages contain a fix. If there is only one likely fix, $(tname) applies \
         it and checks the program again, until no such fix is left. It prints each fix that it \
         applied, and then the remaining messages, as $(b,frobc check) does.";
      `P "Editors offer each fix where it applies: see $(b,frobc lsp).";
    ]
  in
  command "fix" ~man ~doc:"apply the fixes that messages suggest, in place"
    Term.(
      const (fun general diff all files ->
          Tools.Fix_files.(run general ~diff (if all then All else Safe)) files)
      $ general $ diff $ all $ files)

let compile =
  let folder =
    let doc = "The folder for the C files." in
    Arg.(value & opt string "." & info [ "o"; "output" ] ~docv:"DIR" ~doc)
  in
  let batch =
    let doc =
      "Add a function NAME_steps that runs many steps in one call, for replay and simulation."
    in
    Arg.(value & flag & info [ "batch" ] ~doc)
  in
  let standalone =
    let doc =
      "Include the parts of frobc's headers and sources that the two files need, so that they \
       compile without frobc's folders."
    in
    Arg.(value & flag & info [ "standalone" ] ~doc)
  in
  let run general entry batch standalone folder file =
    Commands.compile general entry ~batch ~standalone folder file
  in
  command "compile" ~doc:"translate a program to C, as NAME.c and NAME.h"
    Term.(const run $ not_judging general $ entry $ batch $ standalone $ folder $ file)

let markers =
  let doc =
    "With $(b,--ros2): include the program's drawing, which the node publishes as markers."
  in
  Arg.(value & flag & info [ "markers" ] ~doc)

let drawn general shows = if shows then Tools.Real_robot.with_markers general else general

let refuse_markers () =
  Reporting.wrong_use "--markers only works with --ros2: add --ros2, or remove --markers"

let build =
  let output =
    let doc = "Output file. The default is the program's name." in
    Arg.(value & opt (some string) None & info [ "o"; "output" ] ~docv:"EXE" ~doc)
  in
  let shared =
    let doc =
      "Build a shared object instead, for hosts on this machine that load programs. It contains \
       the program's table and a function NAME_steps that runs many steps in one call."
    in
    Arg.(value & flag & info [ "shared" ] ~doc)
  in
  let target =
    let describe name =
      let meaning = Option.fold ~none:"" ~some:Build.Target.meaning (Build.Target.of_name name) in
      Printf.sprintf "$(b,%s) (%s)" name meaning
    in
    let doc =
      "The machine to build for: " ^ String.concat "; " (List.map describe Build.Target.names) ^ "."
    in
    Arg.(value & opt string "host" & info [ "target" ] ~docv:"TARGET" ~doc)
  in
  let ros2 =
    let doc =
      "Build a ROS 2 node for the robot $(b,ros). Source the setup script of ROS 2 first."
    in
    Arg.(value & flag & info [ "ros2" ] ~doc)
  in
  command "build"
    ~doc:"build the executable that $(b,run --device) or $(b,run --ros2) would start"
    Term.(
      const (fun general entry sources target shared ros2 markers output file ->
          if markers && not ros2 then refuse_markers ()
          else if ros2 && (shared || target <> "host") then
            Reporting.wrong_use
              "--ros2 builds an executable for this machine: remove --shared and --target"
          else if ros2 then
            Tools.Real_robot.build_node (drawn general markers) ~entry ~sources ~output file
          else if shared && target <> "host" then
            Reporting.wrong_use "--shared only works for this machine: remove --target"
          else if shared then Tools.Real_robot.library general ~entry ~sources ~output file
          else Tools.Real_robot.build general ~entry ~sources ~target ~output file)
      $ not_judging general $ entry $ sources $ target $ shared $ ros2 $ markers $ output $ file)

let export =
  let folder =
    let doc =
      "Write a library folder for PlatformIO, named after the program: library.json, the C code in \
       $(b,src), and in $(b,examples) a main program for boards with the Arduino framework."
    in
    Arg.(value & opt (some string) None & info [ "platformio" ] ~docv:"DIR" ~doc)
  in
  let package =
    let doc =
      "Write a ROS 2 package for $(b,colcon build): package.xml, CMakeLists.txt and a launch file, \
       which you may edit, and in $(b,src) the C code of the program and of its node. Later \
       exports to the same folder replace only $(b,src)."
    in
    Arg.(value & opt (some string) None & info [ "ros2" ] ~docv:"DIR" ~doc)
  in
  command "export" ~doc:"export a robot program as a library or package for other build tools"
    Term.(
      const (fun general entry sources folder package markers file ->
          match (folder, package) with
          | Some _, None when markers -> refuse_markers ()
          | Some folder, None -> Tools.Export.platformio general ~entry ~sources ~folder file
          | None, Some folder ->
              Tools.Ros_package.export (drawn general markers) ~entry ~sources ~folder file
          | None, None | Some _, Some _ ->
              Reporting.wrong_use "say what to export: use either --platformio DIR or --ros2 DIR")
      $ general $ entry $ sources $ folder $ package $ markers $ file)

let report =
  let states =
    let dot =
      Arg.info [ "states" ]
        ~doc:"Print the switches and tasks as a state diagram for Graphviz instead."
    and svg = Arg.info [ "svg" ] ~doc:"Print the state diagram of $(b,--states) as SVG." in
    let choose states svg =
      if svg then Some Commands.Svg else if states then Some Commands.Dot else None
    in
    Term.(const choose $ Arg.(value & flag dot) $ Arg.(value & flag svg))
  in
  command "report" ~doc:"show the memory, operations and stack that a step needs"
    Term.(
      const (fun general entry states file -> Commands.report general ~entry ~states file)
      $ general $ entry $ states $ file)

let header =
  let robot =
    Arg.(
      required
      & pos 0 (some string) None
      & info [] ~docv:"ROBOT"
          ~doc:("The robot: " ^ robot_names ^ ", or the module file of your own robot."))
  in
  command "header" ~doc:"write the C header with a robot's input and output types"
    Term.(const Commands.header $ robot)

let selftest =
  let some names ~docv ~doc = Arg.(value & opt (some string) None & info names ~docv ~doc) in
  let cc =
    some [ "cc" ] ~docv:"CC"
      ~doc:
        "The command that starts the C compiler; it may contain options. The default is the \
         compiler that the other commands use: the one in the environment variable $(b,CC); \
         otherwise $(b,cc), $(b,gcc) or $(b,clang); otherwise the compiler that comes with frobc."
  in
  let cflags =
    some [ "cflags" ] ~docv:"FLAGS"
      ~doc:
        (Printf.sprintf
           "Options for compiling and linking, separated by spaces. The default is $(b,%s)."
           (String.concat " " Build.Toolchain.flags))
  in
  let runner =
    some [ "runner" ] ~docv:"COMMAND"
      ~doc:"Command that runs the programs of a cross compiler, such as $(b,qemu-aarch64)."
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Compiles and runs programs that together contain every construct of generated C, and \
         compares their outputs with those of the reference interpreter, bit for bit. Prints a \
         line for each program and the verdict. Standard error lists the faults: arithmetic that \
         does not follow IEEE 754 (contraction, $(b,-ffast-math), another rounding mode), code \
         that does not compile, outputs that differ, and compiler warnings.";
      `P
        "The exit status is 0 if the compiler handles generated C correctly, 1 if it does not, and \
         2 if $(tname) could not test it.";
      `P
        "A compiler for another machine needs an emulator that runs its programs. A compiler for a \
         board also needs a library that prints through the emulator:";
      `Pre
        "frobc selftest --cc aarch64-linux-gnu-gcc \\\\\n\
        \  --cflags \"-O2 -ffp-contract=off -static\" --runner qemu-aarch64\n\
         frobc selftest --cc arm-none-eabi-gcc \\\\\n\
        \  --cflags \"-O2 -ffp-contract=off --specs=rdimon.specs\" --runner qemu-arm";
    ]
  in
  command "selftest" ~man ~doc:"check that your C compiler handles generated C correctly"
    Term.(
      const (fun cc cflags runner real -> Tools.Selftest.run { cc; cflags; runner; real })
      $ cc $ cflags $ runner $ real)

let new_project =
  let folder =
    let doc =
      "The folder to create, as in $(b,rover) or $(b,robots/rover). Its name, which is also the \
       name of the program, consists of letters, digits, $(b,_) and $(b,-)."
    in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"NAME" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Creates a project to start from: a program that drives around without touching anything, \
         trials that check this, a world, a README with the commands to use, and settings for \
         editors. $(tname) does not change an existing folder.";
    ]
  in
  command "new" ~man ~doc:"create a project with a program, its world and its trials"
    Term.(const Tools.New_project.run $ folder)

let explain =
  let code =
    Arg.(
      required
      & pos 0 (some string) None
      & info [] ~docv:"CODE" ~doc:"The code of a diagnostic, such as $(b,E0401).")
  in
  command "explain" ~doc:"explain a diagnostic, with an example and its fix"
    Term.(const Commands.explain $ code)

let extras =
  let action =
    let actions = [ ("install", `Install); ("list", `List) ] in
    let doc = "$(b,install) installs groups of packages; $(b,list) shows what is installed." in
    Arg.(required & pos 0 (some (enum actions)) None & info [] ~docv:"ACTION" ~doc)
  in
  let chosen =
    let describe (g : Tools.Extras.group) =
      Printf.sprintf "$(b,%s) (%s: %s)" g.name g.purpose
        (String.concat ", " (List.map fst g.packages))
    in
    let doc =
      "The groups to install: "
      ^ String.concat "; " (List.map describe Tools.Extras.groups)
      ^ ". Without a group, $(b,install) installs the groups that were installed last."
    in
    Arg.(value & pos_right 0 string [] & info [] ~docv:"GROUP" ~doc)
  in
  let run action groups =
    match (action, groups) with
    | `Install, groups -> Tools.Extras.install groups
    | `List, [] -> Tools.Extras.list ()
    | `List, _ -> Reporting.wrong_use "`frobc extras list` takes no groups: remove them"
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Some commands use third-party Python packages. $(tname) installs them from the Python \
         Package Index into a virtual environment in $(b,~/.local/share/frobc) (or \
         $(b,XDG_DATA_HOME)), and frobc then uses that environment. A new environment replaces the \
         old one only once it is complete.";
      `P
        "If you have activated a virtual environment of your own, frobc uses that one instead: \
         install the packages there with $(b,pip).";
    ]
  in
  command "extras" ~man ~doc:"install the Python packages that some commands use"
    Term.(const run $ action $ chosen)

let ros2 =
  let action =
    let doc = "$(b,import) writes a module for a message type." in
    Arg.(required & pos 0 (some (enum [ ("import", `Import) ])) None & info [] ~docv:"ACTION" ~doc)
  in
  let type_ =
    let doc = "The message type, with its package, as in $(b,my_msgs/Wheels)." in
    Arg.(required & pos 1 (some string) None & info [] ~docv:"PACKAGE/TYPE" ~doc)
  in
  let output =
    let doc = "The file to write. The default is $(b,TYPEMsg.frob) in the current folder." in
    Arg.(value & opt (some string) None & info [ "o"; "output" ] ~docv:"FILE.frob" ~doc)
  in
  let most =
    let doc = "The maximum length of sequences that are unbounded in ROS." in
    Arg.(value & opt int 16 & info [ "most" ] ~docv:"N" ~doc)
  in
  let run `Import type_ output most =
    if most < 1 then Reporting.wrong_use "--most must be at least 1"
    else Tools.Ros_import.import ~most ~output type_
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Reads the definition of a message type from the packages of the ROS 2 installation whose \
         setup script you have sourced. Writes a module with a record for this type, for nodes \
         that define their own topics. Comments in the file list the fields that it omits, such as \
         text fields. You can edit the file.";
    ]
  in
  command "ros2" ~man ~doc:"import ROS 2 message types"
    Term.(const run $ action $ type_ $ output $ most)

let doctor =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Checks everything that a command may need, and prints a line for each: $(b,ok); \
         $(b,note), with the command to type, if something is missing that only some commands \
         need; or $(b,FAIL) if frobc does not work on this computer.";
      `P "The exit status is 1 if there is a $(b,FAIL), otherwise 0.";
    ]
  in
  command "doctor" ~man ~doc:"check this computer for everything that frobc uses"
    Term.(const Tools.Doctor.run $ const ())

let lsp =
  let stdio =
    let doc = "Use standard input and output. This is the default; some editors pass the option." in
    Arg.(value & flag & info [ "stdio" ] ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "A language server for editors: it reports messages while you type, and provides types, \
         definitions, completion, renaming and more through the Language Server Protocol. \
         docs/editors.md describes how to set up an editor.";
    ]
  in
  command "lsp" ~man ~doc:"run the language server for editors"
    Term.(const (fun (_ : bool) -> Language_server.Server.run ()) $ stdio)

let help names =
  let topic =
    let doc = "The command to describe. The default is frobc itself." in
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
  command "help" ~doc:"describe a command and its options" Term.(ret (const show $ topic))

let commands =
  let all =
    [
      new_project;
      Running.demo;
      check;
      fix;
      format;
      compile;
      Running.trace;
      Running.run;
      Trying.test;
      Sweeping.sweep;
      Falsifying.falsify;
      Viewing.view;
      Converting.convert;
      Serving.serve;
      build;
      export;
      report;
      selftest;
      header;
      explain;
      extras;
      ros2;
      doctor;
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
        "In Frob, time is implicit and behaviour is written as equations. $(tname) type-checks a \
         program and translates it to C without heap or recursion, with known bounds on memory and \
         execution time.";
      `P
        "Every command writes only its results to standard output. Errors, warnings and progress \
         go to standard error.";
      `P
        "Start with $(b,frobc demo), which drives an example in the simulator, and $(b,frobc new \
         rover), which creates a project. $(b,frobc help COMMAND) describes a command, and \
         $(b,frobc explain CODE) a message.";
      `S Manpage.s_see_also;
      `P
        "The documentation is installed in share/doc/frobc: a tutorial, how-to pages and the \
         language reference.";
    ]
  in
  Cmd.group (Cmd.info "frobc" ~version:Build.Version.number ~doc ~man ~exits) commands

(* Disables most of the major garbage collection. A compilation is short, and most data
   that survives the minor heap lives until the end, so marking finds little to free. Without
   marking, compiling a large program takes 10 % less time, at the cost of 0.6 GB for 100,000
   lines. (Freeing the front end's trees after Flow would reduce that to 0.5 GB, but would take more
   time than it saves.)

   - [space_overhead]: prevents marking, except in a small heap, because the amount of marking is
     proportional to the fraction of the heap that is new.
   - Heap increment: the heap grows by 32 MB at a time, so it is never small. Only the part that is
     used occupies real memory.
   - Allocation policy: best fit (2, the default) is not worth it if hardly anything is freed; next
     fit (0) is faster.
   - [max_overhead]: disables compaction.
   - Custom memory: file buffers do not trigger marking.
   - The minor heap keeps its size, because a larger one does not fit into the processor's cache. *)
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

(* Prevents cmdliner from parsing the flags of a C compiler (`--cflags -O2`) and the arguments for
   ROS 2 as options of frobc. As for every ROS 2 node, these arguments end at `--` (`--ros-args -r
   odom:=base/odom --`). *)
let rec with_flags = function
  | "--cflags" :: flags :: rest -> ("--cflags=" ^ flags) :: with_flags rest
  | "--ros-args" :: rest -> with_ros_arguments rest
  | argument :: rest -> argument :: with_flags rest
  | [] -> []

and with_ros_arguments = function
  | "--" :: rest -> with_flags rest
  | argument :: rest -> ("--ros-args=" ^ argument) :: with_ros_arguments rest
  | [] -> []

let argv = Array.of_list (with_flags (Array.to_list Sys.argv))

(* Escapes control characters in text from the command line before printing it. *)
let messages =
  let put text from length = prerr_string (Basis.Printable.text (String.sub text from length)) in
  (* If standard error is closed, discard the messages. *)
  let flush () = try flush stderr with Sys_error _ -> () in
  Format.make_formatter put flush

(* A `case` with 200,000 branches needs more stack than the usual 8 MB, because some passes recurse
   along lists. A larger stack would be slow: each minor collection scans the whole stack, so a
   function that recurses until the stack is full takes time quadratic in the stack's size. *)
let largest_stack = 1 lsl 25

(* Command names from other tools, for which cmdliner would suggest the wrong command. *)
let command_meant = function "fmt" -> Some "format" | "lint" -> Some "check" | _ -> None

let evaluate () =
  match if Array.length argv > 1 then command_meant argv.(1) else None with
  | Some command ->
      Printf.eprintf
        "frobc: unknown command '%s', did you mean '%s'?\n\
         Usage: frobc COMMAND …\n\
         Try 'frobc --help' for more information.\n"
        argv.(1) command;
      Error `Parse
  | None -> Cmd.eval_value ~err:messages ~catch:false ~argv main

let () =
  Build.Child.end_with_parent ();
  Build.Child.allow_stack largest_stack;
  collect_seldom ();
  Build.Streams.keep_numbers ();
  let status =
    match evaluate () with
    | Ok (`Ok status) -> status
    | Ok (`Version | `Help) -> Build.Exit_status.ok
    | Error (`Parse | `Term) -> Build.Exit_status.wrong_use
    | Error `Exn -> Build.Exit_status.bug
    | exception exn when Build.Streams.output_fault () = None -> Reporting.report_exception exn
    | exception _ -> Build.Exit_status.wrong_use
  in
  let status =
    match Build.Streams.output_fault () with
    | None -> status
    | Some reason ->
        Printf.eprintf "error: cannot write to standard output: %s\n" reason;
        if status = Build.Exit_status.ok then Build.Exit_status.wrong_use else status
  in
  Build.Streams.drop_unwritable ();
  exit status
