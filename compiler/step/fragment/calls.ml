module F = Flow.Ir
open Basis
open Fragment

type context = { program : F.program; callee : int -> Ir.node; fresh : unit -> int }

let variable = Modes.variable
let broken what = Diagnostic.bug ~stage:"Step.Calls" "%s" what

(* The arguments for the parameters that the callee reads. *)
let arguments context (i : F.instance) (code : Ir.code) =
  let node = context.program.nodes.(i.node) in
  let given = Int_table.create 16 in
  let add (s : F.signal) atom = Int_table.replace given s.id atom in
  List.iter2 add node.statics i.statics;
  List.iter2 add node.inputs i.inputs;
  List.map
    (fun (parameter : Ir.variable) ->
      match Int_table.find_opt given parameter.id with
      | Some atom -> atom
      | None -> broken "a parameter that is neither static nor input")
    code.parameters

(* Variables for all outputs of an instance. If an output is not in [defines], its variable has no
   name and is not used. *)
let results context (i : F.instance) defines =
  let variable_for (s : F.signal) =
    if List.exists (fun (d : F.signal) -> d.id = s.id) defines then variable s
    else { (variable s) with id = context.fresh (); name = "" }
  in
  List.map variable_for i.outputs

let rec zero context (ty : F.ty) : Ir.expr =
  match ty with
  | Bool -> Bool false
  | Int -> Int 0l
  | Float -> Float 0.
  | Sum sum -> (
      match context.program.sums.(sum).constructors with
      | first :: _ ->
          let payload = List.map (zero context) (Flow.Shape.payload first) in
          Construct { sum; constructor = 0; payload }
      | [] -> broken "a sum without constructors")
  | Array (count, element) ->
      Fill { count; element = Layout.ty element; value = zero context element }
  | Foreign ty -> Absent ty

(* Runs a step on a copy of the state, with zeros in place of unknown inputs. *)
let try_out context resolve (i : F.instance) (trial : F.trial) state =
  let node = context.callee i.node in
  let given = List.combine context.program.nodes.(i.node).inputs trial.given in
  let zeros =
    List.filter_map
      (fun ((s : F.signal), a) -> if Option.is_none a then Some (s.id, zero context s.ty) else None)
      given
  in
  let atoms = List.combine node.step.parameters (arguments context i node.step) in
  let is_given ((v : Ir.variable), _) = not (List.mem_assoc v.id zeros) in
  let operands = List.map (fun (_, atom) -> resolve atom) (List.filter is_given atoms) in
  let results = results context i trial.gives in
  (* Arrays are passed by address, so they need variables. *)
  let declare (id, (value : Ir.expr)) =
    match value with
    | Fill { count; element; _ } ->
        let variable : Ir.variable =
          { id = context.fresh (); name = ""; ty = Array (count, element) }
        in
        ((id, Ir.Variable variable), [ Ir.Declare { variable; value; span = i.span } ])
    | value -> ((id, value), [])
  in
  let zeros, declared = List.split (List.map declare zeros) in
  let declared = List.concat declared in
  let rec fill parameters exprs =
    match (parameters, exprs) with
    | [], _ -> []
    | ((v : Ir.variable), _) :: parameters, exprs -> (
        match (List.assoc_opt v.id zeros, exprs) with
        | Some zero, _ -> zero :: fill parameters exprs
        | None, e :: exprs -> e :: fill parameters exprs
        | None, [] -> broken "a trial step with too few arguments")
  in
  let statements exprs =
    let arguments = fill atoms exprs in
    declared
    @ [ Ir.Step { node = i.node; state; arguments; results; on_trial = true; span = i.span } ]
  in
  Draft.work ~defines:trial.gives ~operands ~weight:(2 + node.operations) i.span statements

let loop context resolve (i : F.instance) (l : F.loop) state =
  let node = context.callee i.node in
  let forms = Int_table.create 16 in
  let input k (s : F.signal) form = Int_table.replace forms s.id (k, form) in
  List.iteri
    (fun k (s, form) -> input k s form)
    (List.combine context.program.nodes.(i.node).inputs l.arguments);
  let initial = List.filteri (fun k _ -> List.nth l.arguments k = F.Accumulator) i.inputs in
  let parameters = node.step.parameters in
  let form (p : Ir.variable) = Option.value (Int_table.find_opt forms p.id) ~default:(0, F.Same) in
  let statements exprs =
    let first, others = Long_list.split_at (List.length initial) exprs in
    let argument p e : Ir.argument =
      match form p with
      | k, Accumulator -> Accumulated k
      | _, Element -> Each e
      | _, Same -> Same e
      | _, Counter -> Counted e
    in
    [
      Ir.Loop
        {
          node = i.node;
          state;
          count = l.count;
          initial = first;
          arguments = List.map2 argument parameters others;
          results = List.map variable i.outputs;
          span = i.span;
        };
    ]
  in
  let operands = List.map resolve (initial @ arguments context i node.step) in
  let weight = l.count * (2 + node.operations) in
  Draft.work ~defines:i.outputs ~operands ~always:(Option.is_some state) ~weight i.span statements

let call context resolve (i : F.instance) state =
  let node = context.callee i.node in
  let operands = List.map resolve (arguments context i node.step) in
  match (i.loop, state, i.outputs) with
  | Some l, _, _ -> loop context resolve i l state
  | None, None, [ signal ] when i.trials = [] && not (node.seconds || node.nanoseconds) ->
      let build arguments = Ir.Call { node = i.node; arguments } in
      Computed
        { signal; operands; build; choice = None; weight = 2 + node.operations; span = i.span }
  | None, _, _ ->
      let defines = Flow.Schedule.defines (Instance i) in
      let results = results context i defines in
      let statements arguments =
        [ Ir.Step { node = i.node; state; arguments; results; on_trial = false; span = i.span } ]
      in
      let weight = 2 + node.operations in
      Draft.work ~defines ~operands ~always:(Option.is_some state) ~weight i.span statements

let reset context resolve (i : F.instance) state =
  let node = context.callee i.node in
  let operands = List.map resolve (arguments context i node.reset) in
  let statements arguments = [ Ir.Reset { node = i.node; state; arguments; span = i.span } ] in
  Draft.work ~operands i.span statements
