(* Writes the C of the programs named on the command line, or of all programs. *)

let write path text =
  let out = open_out_bin path in
  output_string out text;
  close_out out

let generate (name, program) =
  let step = Step.Passes.program (Step.Of_flow.program program) in
  Step.Lint.program step;
  let files = Cgen.Emit.program step in
  write (name ^ ".h") files.Cgen.Emit.header;
  write (name ^ ".c") files.Cgen.Emit.source;
  Option.iter (write (name ^ "_host.c")) files.Cgen.Emit.host_table

let () = List.iter generate Programs.all
