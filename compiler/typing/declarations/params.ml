let is_possible (scheme : Ir.scheme) =
  match (scheme, scheme.ty) with
  | { types = []; representations = []; units = []; context = []; _ }, (Number _ | Bool) -> true
  | _, _ -> false

let program ~report (program : Resolve.Ir.program) definitions =
  let table = Resolve.Global_table.create 16 in
  let param (p : Resolve.Ir.param) : Ir.param option =
    Option.map
      (fun (d : Ir.definition) : Ir.param ->
        if not (is_possible d.scheme) then
          report (Declaration_fact.Param { at = d.span; name = p.param.name; scheme = d.scheme });
        { param = p.param; given = p.given; ty = d.scheme.ty; doc = d.doc; span = p.span })
      (Resolve.Global_table.find_opt table p.param)
  in
  if program.params = [] then []
  else (
    List.iter (fun (d : Ir.definition) -> Resolve.Global_table.replace table d.name d) definitions;
    List.filter_map param program.params)
