open Basis

type t = (Span.t, Span.t) Hashtbl.t

let add found (e : Core.Ir.expr) =
  match e.desc with
  | Proc proc ->
      List.iter
        (fun (eq : Core.Ir.equation) -> Hashtbl.replace found eq.binder.local.span eq.span)
        proc.equations
  | _ -> ()

let of_program (program : Core.Ir.program) =
  let found = Hashtbl.create 256 in
  List.iter (fun (d : Core.Ir.definition) -> Core.Term.visit (add found) d.body) program.definitions;
  found

let mem = Hashtbl.mem
let whole = Hashtbl.find_opt
