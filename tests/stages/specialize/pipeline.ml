open Basis

let ( let* ) = Option.bind

(* [Some] unless the sink has heard of errors. *)
let sound sink value = if Diagnostic.has_errors sink then None else Some value

let flow sink source ~files ~library file =
  let remember ~file text = Source.add source ~file text in
  let* resolved = Resolve.Program.load sink ~files ~remember ~library file in
  let* typed = sound sink (Typing.Infer.program sink ~real:Double resolved) in
  let typed = Typing.Levels.program sink typed in
  Typing.Patterns.check sink typed;
  let* typed = sound sink typed in
  let core = Core.Of_typed.program typed in
  let entry : Core.Ir.Global.t = { module_ = core.main_module; name = "main" } in
  let name = Filename.remove_extension (Filename.basename file) in
  let* flow = Specialize.Evaluate.program sink ~name ~entry core in
  Flow.Lint.program flow;
  Some flow
