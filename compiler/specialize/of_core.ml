open Basis
module Ir = Core.Ir

let ends (core : Ir.definition) =
  match (core.parameters, core.ty) with
  | [], (Signal_function (input, output) | Data ({ name = "Program"; _ }, [ input; output ])) ->
      Some (input, output)
  | _, _ -> None

let refuse_interface c definition part ty =
  Context.report c (Entry (Interface { definition; part; ty }))

(* A program that can end has a result in addition to its output. If the output is a record, the
   result is an additional field. *)
let result_field = "result"

let with_result (output : Flow.Ir.shape) result : Flow.Ir.shape =
  match output with
  | Product ({ record = true; _ } as record) ->
      Product { record with parts = record.parts @ [ (result_field, result) ] }
  | Product _ | Leaf _ | Repeated _ ->
      let parts = [ ("", output); ("", result) ] in
      Product { product_name = ""; product_module = ""; constructor = ""; record = false; parts }

exception Unlike_ends

(* A program: its signal function, the type of its result if it can end, and, for a node, the rate
   and the place that sets it. *)
type in_program = {
  signal_function : Value.t;
  ended : Ir.ty option;
  rate : (Value.t * Span.t) option;
}

(* If `main` selects one of several programs at the start, all of them must have the same result
   type. *)
let rec in_program (value : Value.t) =
  match value with
  | Choice { condition; then_; else_ } ->
      let then_ = in_program then_ and else_ = in_program else_ in
      if then_.ended <> else_.ended then raise_notrace Unlike_ends;
      let signal_function : Value.t =
        Choice { condition; then_ = then_.signal_function; else_ = else_.signal_function }
      in
      let rate =
        match (then_.rate, else_.rate) with
        | Some (Atom a, _), Some (Atom b, _) when a = b -> then_.rate
        | None, None -> None
        | Some (_, at), _ | None, Some (_, at) -> Some (Unspecified, at)
      in
      { signal_function; ended = then_.ended; rate }
  | Program (Primitive { primitive = Ending; types = [ _; _; ended ]; arguments = [ inner ]; _ }) ->
      { signal_function = inner.value; ended = Some ended; rate = None }
  | Program (Primitive { primitive = Node; arguments = [ inner; rate ]; at; _ }) ->
      { signal_function = inner.value; ended = None; rate = Some (rate.value, at) }
  | Program signal_function -> { signal_function; ended = None; rate = None }
  | signal_function -> { signal_function; ended = None; rate = None }

(* The limits of the option [--rate]. *)
let slowest = 0.1
and fastest = 1000.

let rate (c : Context.t) ((rate : Value.t), at) =
  let refuse rate =
    Context.report c (Entry (Rate { at; rate; slowest; fastest }));
    None
  in
  match rate with
  | Atom (Float rate) when rate >= slowest && rate <= fastest -> Some rate
  | Atom (Float rate) -> refuse (Some rate)
  | _ -> refuse None

let output_names (c : Context.t) ~output ~ended =
  let names ty root =
    List.map
      (fun (leaf : Types.leaf) -> Types.join root (Types.path_name leaf))
      (Types.layout c.types ty).leaves
  in
  match ended with
  | None -> names output "out"
  | Some ended ->
      names output "out" @ names (Core.Signature.event ended) (Types.join "out" result_field)

(* Drawings are not part of the output. The marks of each drawing follow all other outputs, under a
   separate name. *)
let apart outputs =
  let is_part suffix (name, _) = String.ends_with ~suffix name in
  let is_drawn output = List.exists (fun suffix -> is_part suffix output) Types.paths_of_drawing in
  let drawn, others = List.partition is_drawn outputs in
  (others, List.filter (is_part Types.marks_path) drawn)

let drawings = function
  | [ only ] -> [ ("draw", only) ]
  | several -> List.mapi (fun k marks -> (Printf.sprintf "draw.%d" (k + 1), marks)) several

(* Builds the root node. Returns the type of the program's result (if the program ends), the names
   of its drawings, and the rate (if the program is a node). *)
let root c ~unique (core : Ir.definition) ~input ~output =
  let node = Node.create ~fresh:c.Context.fresh in
  let s : Expression.scope =
    {
      locals = Variables.empty;
      types = Variables.empty;
      node;
      owner = core.name.name;
      trail = Context.start;
    }
  in
  let { signal_function; ended; rate = given } =
    in_program (Expression.expr c s (Named core.name.name) core.body)
  in
  let rate = Option.bind given (rate c) in
  let whole_output : Ir.ty =
    match ended with None -> output | Some ended -> Tuple [ output; Core.Signature.event ended ]
  in
  let names, local, name, span =
    match signal_function with
    | Signal_function { code = Proc proc; name; span; types; _ } ->
        (Destructuring.of_proc c.types types proc, proc.input.local, name, span)
    | _ ->
        let unnamed : Ir.Local.t = { id = 0; name = ""; span = core.span } in
        (Destructuring.none, unnamed, core.name.name, core.span)
  in
  let node_name = unique name in
  let inputs =
    List.map
      (fun (leaf : Types.leaf) ->
        let name = Destructuring.name names local (Types.path_name leaf) in
        Node.signal node ~name ~span:local.span leaf.leaf)
      (Types.layout c.types input).leaves
  in
  let value = Leaves.value c.types input (List.map (fun s -> Flow.Ir.Signal s) inputs) in
  let result =
    match signal_function with
    | Signal_function { code = Proc proc; name; captured; types; _ } ->
        let locals = Expression.bind proc.input input value captured in
        Expression.proc_body c { s with locals; types; owner = name } proc
    | _ ->
        let input : Value.argument = { value; ty = input } in
        Expression.run c s Unnamed ~span ~result:whole_output signal_function input
  in
  let is_first_order = (Types.layout c.types whole_output).first_order in
  if is_first_order then (
    let atoms = Leaves.atoms c.types node ~span whole_output result in
    let outputs, drawn = apart (List.combine (output_names c ~output ~ended) atoms) in
    let outputs = outputs @ drawings (List.map snd drawn) in
    ignore
      (Specialization.finish c node ~name:node_name ~origin:name ~span ~kind:Signal_function
         ~statics:[] ~inputs ~outputs ~transitions:[]);
    (ended, List.map fst (drawings drawn), rate))
  else (
    refuse_interface c core Result (Option.get ended);
    (ended, [], rate))

let param ~default (p : Ir.param) : Flow.Ir.param =
  {
    label = p.label;
    param_ty =
      (match p.ty with
      | Bool -> Bool
      | Int -> Int
      | Float -> Float
      | _ -> Diagnostic.bug ~stage:"Specialize.Of_core" "`%s` is not a number" p.label);
    unit_ = p.unit_;
    default = default p;
    doc = p.doc;
    declared = p.span;
  }

let closed_program (c : Context.t) ~name ~default (core : Ir.definition) ~input ~output :
    Flow.Ir.program option =
  let is_first_order ty = (Types.layout c.types ty).first_order in
  if not (is_first_order input) then refuse_interface c core Input input;
  if not (is_first_order output) then refuse_interface c core Output output;
  let ended = ref None and drawings = ref [] and rate = ref None in
  (if not c.failed then
     (* if the root's evaluation is restarted, the root keeps the name that it chose the first
        time *)
     let chosen = ref None in
     let unique name =
       if Option.is_none !chosen then chosen := Some (Names.unique c.names name);
       Option.value !chosen ~default:name
     in
     let root () =
       let found, drawn, given = root c ~unique core ~input ~output in
       ended := found;
       drawings := drawn;
       rate := given
     in
     try Context.settle root with
     | Context.Stopped -> ()
     | Unlike_ends -> Context.report c (Entry (Different_results core))
     | Stack_overflow ->
         (* {!Context.enter} does not count how deeply functions capture functions *)
         let excess = Limit_fact.Functions_nested core in
         Context.report c (Limit { at = core.span; calls = []; excess })
     | Closure.Needs_itself local -> Context.report c (Entry (Needs_itself local)));
  if c.failed then None
  else
    let input = Types.shape c.types input and output = Types.shape_of_output c.types output in
    let imports = Foreign_code.imports c in
    let output =
      match !ended with
      | None -> output
      | Some ended -> with_result output (Types.shape c.types (Core.Signature.event ended))
    in
    Some
      {
        name;
        real = c.real;
        sums = Types.sums c.types;
        nodes = Array.of_list (List.rev c.nodes);
        next_id = c.fresh ();
        imports;
        headers =
          List.map
            (fun (h : Ir.header) : Flow.Ir.header ->
              { header = h.header; folder = Filename.dirname h.of_file })
            c.foreign.headers;
        input;
        console = (match c.console with Declared controls -> controls | Sought _ -> []);
        output;
        ends = Option.is_some !ended;
        rate = !rate;
        probes = List.map (fun name -> (name, Types.shape_of_marks c.types)) !drawings;
        claims = [];
        marks = (if c.draws then Option.value (Types.marks c.types) ~default:1 else 0);
        params = List.map (param ~default) c.params;
      }

let no_default (p : Ir.param) =
  Diagnostic.bug ~stage:"Specialize.Of_core" "the parameter `%s` has no value" p.label

let closed (c : Context.t) ~name ~default ~(entry : Ir.Global.t) =
  match Resolve.Global_table.find_opt c.definitions entry with
  | None ->
      Diagnostic.bug ~stage:"Specialize.Of_core" "there is no `%s.%s`" entry.module_ entry.name
  | Some { core; _ } -> (
      match ends core with
      | Some (input, output) -> (
          let whole () =
            try closed_program c ~name ~default core ~input ~output with
            | Types.Too_large ty ->
                Used_up.report_type c core ty;
                None
            | Types.Too_deep ty ->
                Used_up.report_nesting c core ty;
                None
          in
          match Work.within (Context.allowed_work c) whole with
          | Some flow -> flow
          | None ->
              Used_up.report_work c core;
              None)
      | None ->
          Diagnostic.bug ~stage:"Specialize.Of_core" "`%s` is not a closed signal function"
            entry.name)

let controls options facts ~name ~entry (program : Ir.program) =
  (* the final specialization reports recursion *)
  if (not (Core.Console.asks program)) || Core.Recursion.facts program <> [] then Some []
  else
    let c = Context.create facts options ~seeks:true program in
    let default _ = Flow.Ir.Bool false in
    ignore (closed c ~name ~default ~entry);
    match c.console with
    | Sought { found } when not c.failed -> Some (List.rev found)
    | Sought _ | Declared _ -> None

let program ?(options = Context.default) ?(default = no_default) facts ~name ~entry
    (program : Ir.program) =
  let c = Context.create facts options program in
  List.iter (fun fact -> Context.report c (Recursion fact)) (Core.Recursion.facts program);
  Foreign_code.check_names c ~name;
  c.failed <- c.failed || Facts.has_errors facts;
  closed c ~name ~default ~entry
