open Basis

let passage (program : Ir.program) passages (node : Dependency.node) (instance : Ir.instance) k w :
    Fact.passage =
  let through = program.nodes.(instance.node) in
  let passed = Dependency.passed_by passages.(instance.node) instance k in
  let is_read j : Ir.atom -> bool = function
    | Signal s -> Dependency.Inputs.mem j passed && node.vertex s = w
    | Bool _ | Int _ | Float _ -> false
  in
  let rec input j (parameters : Ir.signal list) atoms =
    match (parameters, atoms) with
    | p :: _, a :: _ when is_read j a -> p.name
    | _ :: parameters, _ :: atoms -> input (j + 1) parameters atoms
    | [], _ | _, [] -> ""
  in
  {
    through;
    input = input 0 through.inputs instance.inputs;
    output = snd (List.nth through.outputs k);
  }

(* The hop for an edge: a definition of vertex [v] that reads a signal of vertex [w]. *)
let hop program passages (node : Dependency.node) (v, w) : Fact.hop =
  let reading definition =
    let read = List.find_opt (fun s -> node.vertex s = w) (Dependency.reads passages definition) in
    match (definition, read) with
    | _, None | Dependency.Parameter, _ -> None
    | Equation e, Some read -> Some { Fact.reader = e.defines; read; at = e.span; via = [] }
    | Output (instance, k), Some read ->
        let reader = List.nth instance.outputs k in
        let via = [ passage program passages node instance k w ] in
        Some { Fact.reader; read; at = instance.span; via }
    | Box _, Some _ -> None
  in
  match List.find_map reading node.definitions.(v) with
  | Some hop -> hop
  | None -> Diagnostic.bug ~stage:"Flow.Causality" "an edge that does not come from a definition"

let rotate_to first hops =
  let rec go before = function
    | hop :: after when hop != first -> go (hop :: before) after
    | after -> List.rev_append (List.rev after) (List.rev before)
  in
  go [] hops

(* The loop, starting at the named signal that comes first in the source. Merges hops over unnamed
   signals; the place of a merged hop is where the named signal is read. *)
let named_hops hops =
  let earlier (a : Fact.hop) (b : Fact.hop) =
    if Span.compare b.reader.span a.reader.span < 0 then b else a
  in
  match List.filter (fun (hop : Fact.hop) -> hop.reader.name <> "") hops with
  | [] -> None
  | hop :: rest ->
      let first = List.fold_left earlier hop rest in
      let join (joined, (current : Fact.hop)) (hop : Fact.hop) =
        let via = current.via @ hop.via in
        if hop.read.name = "" then (joined, { current with via })
        else
          let next = { hop with reader = hop.read; via = [] } in
          ({ current with read = hop.read; at = hop.at; via } :: joined, next)
      in
      let hops = rotate_to first hops in
      let joined, last = List.fold_left join ([], { first with via = [] }) hops in
      (* The last hop may read an unnamed leaf of the same vertex instead of the leaf that [first]
         defines. *)
      let closing : Fact.hop = List.nth hops (List.length hops - 1) in
      let joined =
        if closing.read.name = "" then { last with read = first.reader; at = closing.at } :: joined
        else joined
      in
      Some (List.rev joined)

let loop program entry passages uses index (node : Dependency.node) component : Fact.loop =
  let cycle = Graph.shortest_cycle node.graph component in
  let next = match cycle with [] -> [] | v :: rest -> List.rev (v :: List.rev rest) in
  let edges = List.rev (List.rev_map2 (fun v w -> (v, w)) cycle next) in
  let hops = Long_list.map (hop program passages node) edges in
  let named = named_hops hops in
  {
    hops = Option.value named ~default:hops;
    named = Option.is_some named;
    sums = program.sums;
    run_by = Own_code.use uses ~entry index;
    entry;
  }

let each_cycle (program : Ir.program) found =
  let cycles passages index (node : Dependency.node) =
    List.iter
      (fun component ->
        if Graph.is_cyclic node.graph component then found passages index node component)
      node.components
  in
  ignore (Dependency.program ~each:cycles program)

let is_causal program =
  let causal = ref true in
  each_cycle program (fun _ _ _ _ -> causal := false);
  !causal

let check facts ~entry (program : Ir.program) =
  let uses = Own_code.uses program in
  each_cycle program (fun passages index node component ->
      Facts.report facts (Fact.Loop (loop program entry passages uses index node component)))
