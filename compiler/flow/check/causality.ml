open Basis

(* An instance in a loop: its node [through] uses the input [input] for its output [output] in the
   same instant. *)
type passage = { through : Ir.node; input : string; output : Ir.atom }

(* An edge of a loop: the definition of [reader] reads [read], at the place [at]. *)
type hop = { reader : Ir.signal; read : Ir.signal; at : Span.t; via : passage list }

let passage (program : Ir.program) passages (node : Dependency.node) (instance : Ir.instance) k w =
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

(* The hop for an edge: a definition of vertex [v] that reads one of vertex [w]. *)
let hop program passages (node : Dependency.node) (v, w) =
  let reading definition =
    let read = List.find_opt (fun s -> node.vertex s = w) (Dependency.reads passages definition) in
    match (definition, read) with
    | _, None | Dependency.Parameter, _ -> None
    | Equation e, Some read -> Some { reader = e.defines; read; at = e.span; via = [] }
    | Output (instance, k), Some read ->
        let reader = List.nth instance.outputs k in
        let via = [ passage program passages node instance k w ] in
        Some { reader; read; at = instance.span; via }
    | Box _, Some _ -> None
  in
  match List.find_map reading node.definitions.(v) with
  | Some hop -> hop
  | None -> Diagnostic.bug ~stage:"Flow.Causality" "an edge that no definition makes"

let rotate_to first hops =
  let rec go before = function
    | hop :: after when hop != first -> go (hop :: before) after
    | after -> List.rev_append (List.rev after) (List.rev before)
  in
  go [] hops

(* The loop, starting at the named signal that comes first in the source. Hops over unnamed signals
   are merged; the place is where the named signal is read. *)
let named_hops hops =
  let earlier a b = if Span.compare b.reader.span a.reader.span < 0 then b else a in
  match List.filter (fun hop -> hop.reader.name <> "") hops with
  | [] -> None
  | hop :: rest ->
      let first = List.fold_left earlier hop rest in
      let join (joined, current) hop =
        let via = current.via @ hop.via in
        if hop.read.name = "" then (joined, { current with via })
        else
          let next = { hop with reader = hop.read; via = [] } in
          ({ current with read = hop.read; at = hop.at; via } :: joined, next)
      in
      let hops = rotate_to first hops in
      let joined, last = List.fold_left join ([], { first with via = [] }) hops in
      (* The loop may end at an unnamed leaf instead of the leaf of [first]. *)
      let closing = List.nth hops (List.length hops - 1) in
      let joined =
        if closing.read.name = "" then { last with read = first.reader; at = closing.at } :: joined
        else joined
      in
      Some (List.rev joined)

let by_a_switch passage = Option.is_some passage.through.machine

let through = function
  | [] -> ""
  | via ->
      let name passage =
        (* the node of a switch is named after the definition that contains it *)
        if by_a_switch passage then "a switch" else Printf.sprintf "`%s`" passage.through.Ir.origin
      in
      ", through " ^ String.concat " and " (List.map name via)

(* A loop may be closed in the library, for example by [loop], around a signal function of the
   program. The user can only change the place where that signal function passes its input
   through. *)
let elsewhere hop =
  List.filter_map
    (fun passage ->
      match passage.output with
      | Signal output when passage.input <> "" && output.span.file <> hop.at.file ->
          Some (passage, output.span)
      | Signal _ | Bool _ | Int _ | Float _ -> None)
    hop.via

let label_elsewhere hop d =
  let label d (passage, at) =
    let text =
      Printf.sprintf "`%s` passes `%s` to this in the same instant" passage.through.Ir.origin
        passage.input
    in
    Diagnostic.label ~at text d
  in
  List.fold_left label d (elsewhere hop)

let reads hop = Printf.sprintf "reads `%s` here%s" hop.read.name (through hop.via)

(* Whether the name can be used as an expression, unlike the name of a component ([p.1]). *)
let is_expression name =
  List.for_all
    (fun part -> part <> "" && not (part.[0] >= '0' && part.[0] <= '9'))
    (String.split_on_char '.' name)

let hint_elsewhere passage =
  Printf.sprintf "let `%s` read the previous value of `%s`, with `delay`" passage.through.Ir.origin
    passage.input

(* The hint for a loop that is closed in the library, whose signals have no names. *)
let hint_within = "put a `delay` or an `integral` into the signal function inside the loop"

(* A likely initial value of the signal, of this type. *)
let initial (program : Ir.program) (signal : Ir.signal) =
  match signal.ty with
  | Bool -> "False"
  | Int | Float -> "0"
  | Sum i -> (
      match program.sums.(i).constructors with
      | { constructor; fields = [] } :: _ -> constructor
      | _ -> "x0")
  | Array _ | Foreign _ -> "x0"

(* The hint for a loop that an equation on one line closes: the equation with the previous value, or
   an integral. *)
let of_equation sources program first last =
  let read = last.read in
  let start = initial program read in
  if String.equal start "x0" || last.via <> [] || not (is_expression read.name) then None
  else
    let shown (cure : Own_equation.t) =
      String.concat " and "
        (List.map
           (fun (name, right) -> Printf.sprintf "`%s = %s`" name right)
           (Option.to_list cure.before @ [ (last.reader.name, cure.right) ]))
    in
    let hint (cure : Own_equation.t) =
      match cure.kind with
      | Integral -> Printf.sprintf "for the sum over time, write %s" (shown cure)
      | Previous ->
          Printf.sprintf "let `%s` read %s: write %s, where %s is the initial value"
            last.reader.name
            (if last.reader.id = read.id then "its own previous value"
             else Printf.sprintf "the previous value of `%s`" first.reader.name)
            (shown cure) start
    in
    Own_equation.cure sources ~name:last.reader.name ~at:last.reader.span ~read:read.name ~start
    |> Option.map (fun (cure : Own_equation.t) d ->
           Diagnostic.hint (hint cure) d
           |> Diagnostic.fix (Printf.sprintf "write %s" (shown cure)) cure.edits)

let hint_here program first last =
  let read = last.read in
  let whose =
    if last.reader.id = read.id then Printf.sprintf "let `%s` read its own previous value" read.name
    else
      Printf.sprintf "let `%s` read the previous value of `%s`" last.reader.name first.reader.name
  in
  if is_expression read.name then
    let start = initial program read in
    let name = if List.mem "before" [ last.reader.name; read.name ] then "earlier" else "before" in
    Printf.sprintf
      "%s: add the equation `%s = delay %s %s`, where %s is the initial value, and read `%s` here"
      whose name start read.name
      (if start = "x0" then "`x0`" else start)
      name
  else whose ^ ", with `delay`"

(* Maximum number of hops in a message. If the loop is longer, the message shows the first ones and
   the last one. *)
let longest_shown = 12

let shorten hops =
  let n = List.length hops in
  if n <= longest_shown then (hops, 0)
  else (List.filteri (fun i _ -> i < longest_shown - 1 || i = n - 1) hops, n - longest_shown)

let report_named sources program entry hops =
  let first = List.hd hops in
  let last = List.nth hops (List.length hops - 1) in
  let at = first.reader.span in
  let label d hop =
    (if Span.compare hop.at at = 0 && d.Diagnostic.here = "" then Diagnostic.here (reads hop) d
     else Diagnostic.label ~at:hop.at (Printf.sprintf "`%s` %s" hop.reader.name (reads hop)) d)
    |> label_elsewhere hop
  in
  let d =
    Diagnostic.error ~code:"E0401" ~at "the signal `%s` needs its own value in the same instant"
      first.reader.name
  in
  let shown, left_out = shorten hops in
  let complete =
    let own (_, (at : Span.t)) = Own_code.is_own ~entry at in
    match (List.concat_map elsewhere hops, Own_code.is_own ~entry last.at) with
    | (_ :: _ as others), false -> Diagnostic.hint (hint_elsewhere (fst (List.hd others)))
    | others, true when List.exists own others ->
        Diagnostic.hint (hint_elsewhere (fst (List.find own others)))
    | _, true ->
        Option.value
          (of_equation sources program first last)
          ~default:(Diagnostic.hint (hint_here program first last))
    | [], false -> Diagnostic.hint hint_within
  in
  let d = List.fold_left label d shown |> complete in
  let d =
    if List.exists (fun hop -> List.exists by_a_switch hop.via) hops then
      Diagnostic.note
        "each output of a switch depends on every input that the signal functions inside the \
         switch read in the same instant"
        d
    else d
  in
  if left_out = 0 then d
  else
    Diagnostic.note
      (Printf.sprintf "the loop goes through %d more signals before `%s`" left_out last.reader.name)
      d

let report_unnamed hops =
  let earlier a b = if Span.compare b.at a.at < 0 then b else a in
  let first = List.fold_left earlier (List.hd hops) hops in
  let d =
    Diagnostic.error ~code:"E0401" ~at:first.at "a signal needs its own value in the same instant"
  in
  let label d hop =
    if Span.compare hop.at first.at = 0 then d
    else Diagnostic.label ~at:hop.at ("the loop goes through here" ^ through hop.via) d
  in
  List.fold_left label d (fst (shorten (rotate_to first hops)))
  |> Diagnostic.here ("the value comes back here" ^ through first.via)
  |> Diagnostic.hint "read the previous value instead, with `delay`"

let report sources program entry passages uses index (node : Dependency.node) component =
  let cycle = Graph.shortest_cycle node.graph component in
  let next = match cycle with [] -> [] | v :: rest -> List.rev (v :: List.rev rest) in
  let edges = List.rev (List.rev_map2 (fun v w -> (v, w)) cycle next) in
  let hops = Long_list.map (hop program passages node) edges in
  let d =
    match named_hops hops with
    | Some hops -> report_named sources program entry hops
    | None -> report_unnamed hops
  in
  match Own_code.use uses ~entry index with
  | None -> d
  | Some (name, at) -> Diagnostic.label ~at (Printf.sprintf "`%s` runs here" name) d

let check sink ~sources ~entry (program : Ir.program) =
  let uses = Own_code.uses program in
  let report_cycles passages index (node : Dependency.node) =
    List.iter
      (fun component ->
        if Graph.is_cyclic node.graph component then
          Diagnostic.emit sink (report sources program entry passages uses index node component))
      node.components
  in
  ignore (Dependency.program ~each:report_cycles program)
