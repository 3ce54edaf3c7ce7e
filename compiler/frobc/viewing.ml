open Cmdliner
open Options
module Page = Tools.Viewing

(* An option of [frobc view] and [frobc run --view]. *)
let print_address =
  let doc = "Print the address of the page and do not open a browser." in
  Arg.(value & flag & info [ "print" ] ~doc)

(* `--view=print` is the older spelling of `--view --print`. *)
let look =
  let parts = [ ("print", `Print); ("control", `Control) ] in
  let doc =
    "Show the run live on a page with all signals, in real time; without $(b,--for), the run \
     continues until you stop it. Prints the address of the page. If there is a desktop, also \
     opens a browser, unless you add $(b,--print). $(b,--view=control) lets viewers send events to \
     a real robot; otherwise they can only stop it."
  in
  let make view print =
    match view with
    | None when print -> Error "--print only works with --view: add --view, or remove --print"
    | None -> Ok None
    | Some parts ->
        let browser = not (print || List.mem `Print parts) in
        Ok (Some { Page.browser; control = List.mem `Control parts })
  in
  Term.(
    const make
    $ Arg.(
        value
        & opt ~vopt:(Some []) (some (list (enum parts))) None
        & info [ "view" ] ~docv:"HOW" ~doc)
    $ print_address)

(* {1 The command} *)

let recording =
  let doc = "The recording, written by $(b,frobc run --record)." in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"RUN.csv" ~doc)

let file =
  let doc = "The $(b,.frob) program that was recorded." in
  Arg.(required & pos 1 (some string) None & info [] ~docv:"FILE" ~doc)

let port =
  let doc = "The port on which to serve the page. The default is any free port." in
  Arg.(value & opt (some int) None & info [ "port" ] ~docv:"N" ~doc)

let world =
  let doc =
    "The world to draw on the map. The default is the world that $(b,frobc run) would use."
  in
  Arg.(value & opt (some string) None & info [ "world" ] ~docv:"WORLD.toml" ~doc)

let only_build =
  let doc =
    "Compile the program for the viewer and print the path of the result, without opening the page."
  in
  Arg.(value & flag & info [ "only-build" ] ~doc)

let why_nan =
  let doc =
    "Do not open the page. Print the origin of a NaN in the program's output: the name and line of \
     the signal that is NaN although no signal that it depends on is NaN."
  in
  Arg.(value & flag & info [ "why-nan" ] ~doc)

let compare =
  let doc =
    "A second recording to show over the first one, of this program or of another version of it."
  in
  Arg.(value & opt (some string) None & info [ "compare" ] ~docv:"OTHER.csv" ~doc)

let seed =
  let doc = "The seed of the recorded simulator run, so that the page can repeat the run." in
  Arg.(value & opt int 1 & info [ "seed" ] ~docv:"N" ~doc)

let at =
  let doc = "The time to show first, as in $(b,12.5s). The default is the start." in
  let parse text = Result.map_error (fun e -> `Msg e) (Build.Time_span.parse_instant text) in
  let print out at = Format.pp_print_string out (Build.Time_span.print at) in
  let time = Arg.conv (parse, print) in
  Arg.(value & opt (some time) None & info [ "at" ] ~docv:"TIME" ~doc)

let view =
  let run general dialect entry sources print port world compare seed at only_build why_nan
      recording file =
    (* Also accept the order of `trace` and `run`, in which the program comes first. *)
    let is_program name = Filename.check_suffix name ".frob" in
    let recording, file =
      if is_program recording && not (is_program file) then (file, recording) else (recording, file)
    in
    let recording = if only_build && recording = "-" then None else Some recording in
    Page.view general ~entry ~sources
      {
        recording;
        dialect;
        browser = not print;
        port;
        world;
        compare;
        seed;
        at;
        only_build;
        why_nan;
      }
      file
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Runs the program again on the recorded inputs, and shows each of its signals at any \
         instant, in plots and in the source. It compares the outputs with the recorded ones.";
      `P
        "The page is only available on this computer, at the printed address. To open it on \
         another computer, run $(b,ssh -L PORT:127.0.0.1:PORT) there and use the same address.";
    ]
  in
  command "view" ~man ~doc:"show a recorded run on a page, at any instant"
    Term.(
      const run $ with_params general $ dialect $ entry $ sources $ print_address $ port $ world
      $ compare $ seed $ at $ only_build $ why_nan $ recording $ file)
