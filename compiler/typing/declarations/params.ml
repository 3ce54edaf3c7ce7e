open Basis

let refuse sink ~at ?hint format =
  Printf.ksprintf
    (fun text ->
      Diagnostic.error ~code:"E0390" ~at "%s" text
      |> Diagnostic.note
           "a parameter must be a number or a `Bool`, so that the command line can set it"
      |> Option.fold ~none:Fun.id ~some:Diagnostic.hint hint
      |> Diagnostic.emit sink)
    format

let check sink ~at name (scheme : Ir.scheme) =
  match (scheme, scheme.ty) with
  | { types = []; representations = []; units = []; context = []; _ }, (Number _ | Bool) -> ()
  | { units = _ :: _; _ }, Number _ | { representations = _ :: _; _ }, Number _ ->
      refuse sink ~at "the parameter `%s` cannot be of every type `%s`" name (Show.scheme scheme)
        ~hint:"name its unit, as in `Float[1/m]`"
  | _, (Function _ | Signal_function _) ->
      refuse sink ~at "the parameter `%s` cannot be of type `%s`" name (Show.scheme scheme)
        ~hint:"use a number as the parameter, and let the function use it"
  | _, (Tuple _ | Data _) ->
      refuse sink ~at "the parameter `%s` cannot be of type `%s`" name (Show.scheme scheme)
        ~hint:"declare a parameter for each number in it; for a choice, use a `Bool` or an `Int`"
  | _, (Variable _ | Number _ | Bool | String | Size _) ->
      refuse sink ~at "the parameter `%s` cannot be of type `%s`" name (Show.scheme scheme)

let program sink (program : Resolve.Ir.program) definitions =
  let table = Resolve.Global_table.create 16 in
  let param (p : Resolve.Ir.param) : Ir.param option =
    Option.map
      (fun (d : Ir.definition) : Ir.param ->
        check sink ~at:d.span p.param.name d.scheme;
        { param = p.param; given = p.given; ty = d.scheme.ty; doc = d.doc; span = p.span })
      (Resolve.Global_table.find_opt table p.param)
  in
  if program.params = [] then []
  else (
    List.iter (fun (d : Ir.definition) -> Resolve.Global_table.replace table d.name d) definitions;
    List.filter_map param program.params)
