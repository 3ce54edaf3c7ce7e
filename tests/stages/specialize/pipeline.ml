open Basis

let ( let* ) = Option.bind

let flow sink source ~files ~library file =
  let remember ~file text = Source.add source ~file text in
  let* resolved =
    Resolve.Program.load (Advice.Of_resolve.into sink) ~files ~remember ~library file
  in
  let* typed = Typing.Of_resolved.program (Advice.Of_typing.into sink) ~real:Double resolved in
  let core = Core.Of_typed.program typed in
  let entry : Core.Ir.Global.t = { module_ = core.main_module; name = "main" } in
  let name = Filename.remove_extension (Filename.basename file) in
  let* flow = Specialize.Of_core.program (Advice.Of_specialize.into sink) ~name ~entry core in
  Flow.Lint.program flow;
  Some flow
