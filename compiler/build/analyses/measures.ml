type t = { name : string; unit_ : string; probe : string }

let measures (equation : Core.Ir.equation) =
  match equation.rhs with
  | Run { signal_function = { desc = Global (g, _); _ }; _ } -> Resolve.Labels.is_measuring g
  | Run _ | Pure _ -> false

(* The places where equations of the main module define a measurement. *)
let places (core : Core.Ir.program) =
  let found = Hashtbl.create 8 in
  let add (e : Core.Ir.expr) =
    match e.desc with
    | Proc { equations; _ } ->
        let note (eq : Core.Ir.equation) =
          if measures eq then Hashtbl.replace found eq.binder.local.span ()
        in
        List.iter note equations
    | _ -> ()
  in
  let is_own (d : Core.Ir.definition) =
    Resolve.Test_file.is_module_of d.name.module_ ~main:core.main_module
  in
  List.iter
    (fun (d : Core.Ir.definition) -> if is_own d then Core.Term.visit add d.body)
    core.definitions;
  found

let of_judge typed core probes =
  let places = places core and written = Probe.Signal_types.of_program typed in
  let is_measured (p : Probe.Catalogue.probe) = (not p.handed_down) && Hashtbl.mem places p.span in
  let measured = List.filter is_measured probes in
  let of_probe (p : Probe.Catalogue.probe) =
    let same (q : Probe.Catalogue.probe) = String.equal p.signal q.signal in
    let is_alone = List.length (List.filter same measured) = 1 in
    let unit_ = Option.bind (Probe.Signal_types.type_of written p) Probe.Signal_types.unit_ in
    {
      name = (if is_alone then p.signal else p.name);
      unit_ = Option.value unit_ ~default:"";
      probe = p.name;
    }
  in
  List.map of_probe measured
