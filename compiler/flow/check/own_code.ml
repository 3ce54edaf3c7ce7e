open Basis

type uses = { program : Ir.program; first : (int * Ir.instance) option array }

let is_own ~(entry : Span.t) (at : Span.t) =
  String.equal (Filename.dirname entry.file) (Filename.dirname at.file)

let uses (program : Ir.program) =
  let first = Array.make (Array.length program.nodes) None in
  let note caller (instance : Ir.instance) =
    if Option.is_none first.(instance.node) then first.(instance.node) <- Some (caller, instance)
  in
  Array.iteri (fun i (caller : Ir.node) -> List.iter (note i) caller.instances) program.nodes;
  { program; first }

let use { program; first } ~(entry : Span.t) index =
  let own (node : Ir.node) = String.equal node.file entry.file in
  let rec outwards i =
    match first.(i) with
    | None -> (program.nodes.(i).origin, entry)
    | Some (caller, (instance : Ir.instance)) ->
        if own program.nodes.(caller) then (program.nodes.(instance.node).origin, instance.span)
        else outwards caller
  in
  if own program.nodes.(index) then None else Some (outwards index)
