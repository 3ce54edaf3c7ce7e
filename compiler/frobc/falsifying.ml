open Cmdliner
open Options
module Falsification = Tools.Falsification

let several name ~docv ~doc = Arg.(value & opt_all string [] & info [ name ] ~docv ~doc)

let params =
  several "param" ~docv:"NAME=\"LOW to HIGH\""
    ~doc:
      "Search over this parameter of the program, as in $(b,--param 'kTurn=2[1/m] to 8[1/m]'). Can \
       be repeated."

let inputs =
  several "input" ~docv:"NAME=\"LOW to HIGH\""
    ~doc:
      "Search over this input, named like a column of a trace, in base units: $(b,--input \
       'in.speed=0 to 1'). With a single value, as in $(b,in.speed=0.5), the input is constant. \
       Use this option for every input of the program."

let disturbances =
  several "disturbance" ~docv:"TABLE.KEY=\"LOW to HIGH\""
    ~doc:
      "For robot programs: search over this number in the world file, as in $(b,--disturbance \
       'sonar.noise=0 to 0.05') or $(b,--disturbance 'start.x=1 to 2'). Can be repeated."

let seeds =
  let doc =
    "For robot programs: search over these seeds of the world's noise, as in $(b,1 to 100)."
  in
  Arg.(value & opt (some string) None & info [ "seeds" ] ~docv:"LOW to HIGH" ~doc)

let world =
  let doc = "For robot programs: the world. The default is the same as for $(b,frobc run)." in
  Arg.(value & opt (some string) None & info [ "world" ] ~docv:"WORLD.toml" ~doc)

let duration = Arg.(value & opt time_span 60. & info [ "for" ] ~docv:"TIME" ~doc:"Length of a run.")
let rate = Arg.(value & opt float 50. & info [ "rate" ] ~docv:"HZ" ~doc:"Instants per second.")

let check_rate =
  let doc =
    "Repeat each violating run with this many instants per second, and report the violation only \
     if it also occurs at this rate. This is useful for programs that model a continuous system."
  in
  Arg.(value & opt (some float) None & info [ "check-rate" ] ~docv:"HZ" ~doc)

let points =
  let doc = "Number of values, at equal intervals, that each input takes in a run." in
  Arg.(value & opt int 10 & info [ "points" ] ~docv:"N" ~doc)

let linear =
  let doc =
    "Interpolate each input linearly between its values, instead of changing it in steps."
  in
  Arg.(value & flag & info [ "linear" ] ~doc)

let only = several "only" ~docv:"LABEL" ~doc:"Check only this assertion. Can be repeated."

let runs =
  Arg.(
    value & opt int 1000
    & info [ "runs" ] ~docv:"N" ~doc:"Maximum number of runs for each assertion.")

let seed =
  let doc = "Seed of the search; the same seed leads to the same result." in
  Arg.(value & opt int 1 & info [ "seed" ] ~docv:"N" ~doc)

let method_ =
  let doc =
    "The search method: $(b,cma) for CMA-ES, which needs the Python packages numpy and cma, or \
     $(b,random) for random search, which needs only numpy."
  in
  let all = [ ("cma", "cma"); ("random", "random") ] in
  Arg.(value & opt (enum all) "cma" & info [ "method" ] ~docv:"METHOD" ~doc)

let keep =
  let doc = "Folder in which to save the inputs of violating runs." in
  Arg.(value & opt string "falsified" & info [ "keep" ] ~docv:"DIR" ~doc)

let falsify =
  let run general entry sources params inputs disturbances seeds world duration rate check_rate
      points linear only runs seed method_ keep file =
    Falsification.run general ~entry ~sources
      {
        params;
        inputs;
        disturbances;
        seeds;
        world;
        duration;
        rate;
        check_rate;
        points;
        linear;
        only;
        runs;
        seed;
        method_;
        keep;
      }
      file
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Searches the given ranges of parameters and inputs for a run that violates an assertion \
         of the program. The search prefers runs that come close to a violation, as measured by \
         the margin of a comparison: the difference between its two sides. If an assertion has \
         several comparisons, the search uses the one that determines the result.";
      `P
        "Robot programs run in the simulator. For them, the search varies parameters, disturbances \
         and seeds, and also looks for collisions.";
      `P
        "Prints a line for each assertion and, if the assertion was violated, the command that \
         shows the run. The exit status is 1 if an assertion was violated. Finding no violation \
         does not prove that there is none.";
      `P "Needs Python packages, which $(b,frobc extras install search) installs.";
    ]
  in
  command "falsify" ~man ~doc:"search for a run that violates an assertion"
    Term.(
      const run $ general $ entry $ sources $ params $ inputs $ disturbances $ seeds $ world
      $ duration $ rate $ check_rate $ points $ linear $ only $ runs $ seed $ method_ $ keep $ file)
