open Checking
open Session

let instants context ~lasts path =
  let channel = open_out path in
  output_string channel "time\n";
  let rec write k =
    let time = float_of_int k /. context.options.rate in
    if time <= lasts +. 1e-9 then (
      Printf.fprintf channel "%.9f\n" time;
      write (k + 1))
  in
  write 0;
  close_out channel

(* Writes the test's input, which consists of times only, to a file for the user. *)
let written context ~reads ~lasts path =
  let open Basis.Let_syntax.Result in
  let* () = Output.folder context.options.keep in
  let* () = Output.check ~reads:[ reads ] [ { path; content = Table; asked = "--keep" } ] in
  match instants context ~lasts path with
  | () -> Ok ()
  | exception Sys_error reason -> Error ("cannot write " ^ reason)

let run context file (check : Checks.t) : Outcome.t =
  let entry = Resolve.Labels.judge check.name in
  let outcome result evidence =
    {
      Outcome.file;
      label = check.label;
      lasts = check.lasts;
      measures = [];
      chance = None;
      note = "";
      result;
      evidence;
    }
  in
  let general = { context.general with probes = [ Probes.claims ] } in
  match compiled context general ~entry file with
  | Error reason -> outcome (Error reason) None
  | Ok program -> (
      let times = Filename.concat (Temporary.folder ()) "times.csv" in
      instants context ~lasts:check.lasts times;
      match Workers.run ~jobs:1 [ (context.resources.trace_host, [ program; times ]) ] with
      | [ ({ status = 0; _ } as result) ] ->
          let run = Found.of_trace result.output in
          let evidence () =
            let input = kept context file check "" ^ ".csv" in
            let view, note =
              match written context ~reads:file ~lasts:run.at input with
              | Error note -> (test_again context file check, note)
              | Ok () ->
                  ( Printf.sprintf "frobc view %s %s%s --entry %s --at %s"
                      (Basis.Printable.path input) (Basis.Printable.path file)
                      (program_words context) (quoted entry) (Time_span.print run.at),
                    "" )
            in
            let look = { Outcome.around = []; picture = ""; view } in
            Some { Outcome.run; look; simpler = None; note }
          in
          let failed = run.fate = Violated || run.fate = Undecided in
          outcome (Ok [ run ]) (if failed then evidence () else None)
      | [ result ] -> outcome (Error (complaint result)) None
      | _ -> outcome (Error "cannot be run") None)
