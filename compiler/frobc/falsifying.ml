open Cmdliner
open Options
module Falsification = Driver.Falsification

let several name ~docv ~doc = Arg.(value & opt_all string [] & info [ name ] ~docv ~doc)

let params =
  several "param" ~docv:"NAME=\"LOW to HIGH\""
    ~doc:
      "Search over this parameter of the program, as in $(b,--param 'kTurn=2[1/m] to 8[1/m]'). May \
       be given several times."

let inputs =
  several "input" ~docv:"NAME=\"LOW to HIGH\""
    ~doc:
      "Search over this input, a column as in a trace, in base units: $(b,--input 'in.speed=0 to \
       1'). With one value, $(b,in.speed=0.5), it has that all the time. All inputs have to be \
       given."

let disturbances =
  several "disturbance" ~docv:"TABLE.KEY=\"LOW to HIGH\""
    ~doc:
      "Of a program that drives a robot: search over this number of the world file, as in \
       $(b,--disturbance 'sonar.noise=0 to 0.05') or $(b,--disturbance 'start.x=1 to 2'). May be \
       given several times."

let seeds =
  let doc = "Likewise: search over these seeds of the world's noise, as $(b,1 to 100)." in
  Arg.(value & opt (some string) None & info [ "seeds" ] ~docv:"LOW to HIGH" ~doc)

let world =
  let doc = "Likewise: its world. The default is that of $(b,frobc run)." in
  Arg.(value & opt (some string) None & info [ "world" ] ~docv:"WORLD.toml" ~doc)

let duration =
  Arg.(value & opt time_span 60. & info [ "for" ] ~docv:"TIME" ~doc:"How long a run is.")

let rate = Arg.(value & opt float 50. & info [ "rate" ] ~docv:"HZ" ~doc:"Instants a second.")

let check_rate =
  let doc =
    "Judge what is found once more with so many instants a second, and let it count only if it is \
     violated there too: for programs that are models of something continuous."
  in
  Arg.(value & opt (some float) None & info [ "check-rate" ] ~docv:"HZ" ~doc)

let points =
  let doc = "So many values in a run, at equal distances, of each input." in
  Arg.(value & opt int 10 & info [ "points" ] ~docv:"N" ~doc)

let linear =
  let doc = "Between these values inputs change evenly, instead of all at once." in
  Arg.(value & flag & info [ "linear" ] ~doc)

let only = several "only" ~docv:"LABEL" ~doc:"Only this assertion; may be given several times."

let runs =
  Arg.(value & opt int 1000 & info [ "runs" ] ~docv:"N" ~doc:"At most so many for an assertion.")

let seed =
  let doc = "Of the search; the same seed finds the same." in
  Arg.(value & opt int 1 & info [ "seed" ] ~docv:"N" ~doc)

let method_ =
  let doc =
    "$(b,cma), CMA-ES, which needs the Python package cma; or $(b,random), which is blind and \
     needs nothing."
  in
  let all = [ ("cma", "cma"); ("random", "random") ] in
  Arg.(value & opt (enum all) "cma" & info [ "method" ] ~docv:"METHOD" ~doc)

let keep =
  let doc = "The folder for the inputs of runs that are found." in
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
        "Looks for a run in which an assertion of the program is violated, over ranges of its \
         parameters and inputs. How nearly the assertion held guides the search: by how much a \
         comparison held, and of several the one that decides.";
      `P
        "A program that drives a robot does so in the simulator. There it is searched over \
         parameters, disturbances and seeds, and it is an assertion too that the robot touches \
         nothing.";
      `P
        "A line for each assertion, and for each that was violated the command that shows the run. \
         The exit status is 1 if there is one. That none was found proves nothing.";
      `P "Needs Python with the package frob and numpy, and for $(b,--method cma) the package cma.";
    ]
  in
  command "falsify" ~man ~doc:"look for a run in which an assertion is violated"
    Term.(
      const run $ general $ entry $ sources $ params $ inputs $ disturbances $ seeds $ world
      $ duration $ rate $ check_rate $ points $ linear $ only $ runs $ seed $ method_ $ keep $ file)
