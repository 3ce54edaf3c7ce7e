open Basis

let bug format = Diagnostic.bug ~stage:"Specialize.Task" format

type head =
  | Runs of {
      signal_function : Value.t;
      primitive : Core.Primitive.t;
      output : Core.Ir.ty;
      result : Core.Ir.ty;
    }
  | Ends of Value.argument
  | Passes

let type_of input output result : Core.Ir.ty =
  Data ({ module_ = "Prelude"; name = "Task" }, [ input; output; result ])

let is_task (p : Core.Primitive.t) =
  match p with Make_task | Until_right | Return | Sequence -> true | _ -> false

let rec named (c : Context.t) ~name ~at (value : Value.t) : Value.t =
  match value with
  | Primitive ({ primitive; _ } as p) when is_task primitive -> (
      let owner : Core.Ir.Global.t = { module_ = "Prelude"; name = p.owner } in
      let is_library's = Resolve.Global_table.mem c.definitions owner in
      match (Context.in_prelude c p.at, Context.in_prelude c at) with
      | true, true -> value
      | is_there, _ when is_there || is_library's ->
          let owner = if is_library's then Option.value name ~default:p.owner else p.owner in
          Primitive { p with owner; at = (if is_there then at else p.at) }
      | _ -> value)
  | Choice { condition; then_; else_ } ->
      let then_ = named c ~name ~at then_ in
      Choice { condition; then_; else_ = named c ~name ~at else_ }
  | value -> value

let place_of ~otherwise (continuation : Value.t) =
  match continuation with Function { code = Lambda (_, body); _ } -> body.span | _ -> otherwise

(* No reasonable program has this many consecutive tasks that end immediately. *)
let most_at_once = 1000

let report_circle (c : Context.t) ~span (hops : Restart_fact.hop list) =
  let places = List.map (fun (hop : Restart_fact.hop) -> hop.place) hops in
  let own = List.filter (fun place -> not (Context.in_prelude c place)) places in
  let at = match List.rev own with [] -> span | last :: _ -> last in
  Context.stop c (Restart (In_one_instant { at; hops; own }))

(* In messages about a task that ends immediately, replaces the name of the library function with
   the name of the definition that uses it. *)
let rec ended_by (c : Context.t) owner (task : Value.t) : Value.t =
  let is_library's name =
    Resolve.Global_table.mem c.definitions { Core.Ir.Global.module_ = "Prelude"; name }
  in
  match task with
  | Primitive ({ primitive = Return; _ } as p) when is_library's p.owner && not (is_library's owner)
    ->
      Primitive { p with owner }
  | Choice { condition; then_; else_ } ->
      let then_ = ended_by c owner then_ in
      Choice { condition; then_; else_ = ended_by c owner else_ }
  | task -> task

let sequence types owner at first rest : Value.t =
  Primitive { primitive = Sequence; types; arguments = [ rest; first ]; owner; at }

let returned types result owner at : Value.t =
  Primitive { primitive = Return; types; arguments = [ result ]; owner; at }

let rec head (task : Value.t) =
  match task with
  | Primitive { primitive = Sequence; arguments = [ _; first ]; _ } -> (
      match head first.value with Ends _ -> Passes | head -> head)
  | Primitive
      {
        primitive = (Make_task | Until_right) as primitive;
        types = [ _; output; result ];
        arguments = [ signal_function ];
        _;
      } ->
      Runs { signal_function = signal_function.value; primitive; output; result }
  | Primitive { primitive = Return; arguments = [ value ]; _ } -> Ends value
  | _ -> bug "a value that is not a reduced task"

let rec first : Value.t -> Value.t option = function
  | Primitive { primitive = Sequence; arguments = [ _; before ]; _ } -> first before.value
  | Primitive { primitive = Make_task | Until_right; arguments = [ runs ]; _ } -> Some runs.value
  | _ -> None

let unnamed span : Core.Ir.Local.t = { id = 0; name = ""; span }

let keeps_nothing (proc : Core.Ir.proc) =
  List.for_all
    (fun (e : Core.Ir.equation) -> match e.rhs with Pure _ -> true | Run _ -> false)
    proc.equations

(* The result of a task, if the task is known to end in its first instant. Constructor 1 is [Event]
   or [Right]. *)
let end_at_once (p : Evaluator.position) (evaluator : Evaluator.t) input = function
  | Ends _ | Passes -> None
  | Runs { signal_function; primitive; output; result } -> (
      match signal_function with
      | Signal_function { code = Proc proc; _ } when keeps_nothing proc ->
          let p = { p with span = proc.output.span } in
          let run result = evaluator.run p ~result signal_function input in
          let ty, value =
            if primitive = Make_task then
              let event = Core.Signature.event result in
              (event, Leaves.component (run (Tuple [ output; event ])) 1)
            else
              let either = Core.Signature.either output result in
              (either, run either)
          in
          let of_value f = f p.types p.node Node.Unnamed ~span:p.span ty value in
          if of_value Leaves.is_constructor 1 = Bool true then
            Some { Value.value = of_value Leaves.payload ~constructor:1 ~field:0; ty = result }
          else None
      | _ -> None)

let reduced (p : Evaluator.position) (evaluator : Evaluator.t) ?input task =
  let { Evaluator.context = c; node; span; _ } = p in
  (* A common key for the continuation and the result, with holes in place of their numbers, and the
     numbers themselves. *)
  let key ~span (rest : Value.argument) (value : Value.argument) =
    let walk = Specialization_key.walk c.keys node Holes in
    Specialization_key.add walk (unnamed span) rest.ty rest.value;
    Specialization_key.add walk (unnamed span) value.ty value.value;
    let numbers =
      List.map (fun (h : Specialization_key.hole) -> h.atom) (Specialization_key.take_holes walk)
    in
    (Specialization_key.key walk, numbers)
  in
  (* Returns the extended chain, or [None] if the task must become a mode. Reports an endless cycle
     if a step recurs with the same numbers, or if the chain is too long. If a step recurs with
     other numbers, it is known only at run time whether the chain ends, so the task becomes a
     mode. *)
  let enter ~span ~ended ~by chain (rest : Value.argument) value =
    let key, numbers = key ~span rest value in
    let rec since found = function
      | (k, before, hop) :: _ when k = key -> Some (before, hop :: found)
      | (_, _, hop) :: others -> since (hop :: found) others
      | [] -> None
    in
    match since [] chain with
    | Some (before, circle) when compare before numbers = 0 -> report_circle c ~span circle
    | Some _ -> None
    | None when List.compare_length_with chain most_at_once >= 0 ->
        report_circle c ~span (List.rev_map (fun (_, _, hop) -> hop) chain)
    | None ->
        let place = place_of ~otherwise:span rest.value in
        Some ((key, numbers, { Restart_fact.ended; by; place }) :: chain)
  in
  (* [span]: the nearest enclosing place outside the prelude. *)
  let rec reduce ~span chain (task : Value.t) : Value.t =
    match task with
    | Primitive { primitive = Sequence; types; arguments = [ rest; first ]; owner; at } ->
        let a, b, d =
          match types with
          | [ a; b; _; d ] -> (a, b, d)
          | _ -> bug "a sequence with unexpected types"
        in
        let span = if Context.in_prelude c at then span else at in
        follow ~span chain types (owner, at) rest
          { first with value = reduce ~span chain first.value }
          ~result:(type_of a b d)
    | Choice { condition; then_; else_ } ->
        let then_ = reduce ~span chain then_ in
        Choice { condition; then_; else_ = reduce ~span chain else_ }
    | Primitive { primitive = Make_task | Until_right; types = [ a; b; c ]; owner; at; _ } -> (
        match Option.bind input (fun input -> end_at_once p evaluator input (head task)) with
        | Some result -> returned [ c; a; b ] result owner at
        | None -> task)
    | task -> task
  and follow ~span chain types origin rest (first : Value.argument) ~result =
    match first.value with
    | Primitive { primitive = Return; arguments = [ value ]; owner; _ } -> (
        match enter ~span ~ended:owner ~by:(fst origin) chain rest value with
        | Some ((_, _, { place; _ }) :: _ as chain) ->
            let task = evaluator.apply { p with span = place } ~result rest.value [ value ] in
            reduce ~span chain task |> ended_by c (fst origin)
        | Some [] | None -> sequence types (fst origin) (snd origin) first rest)
    | Choice { condition; then_; else_ } ->
        let branch value = follow ~span chain types origin rest { first with value } ~result in
        let then_ = branch then_ in
        Choice { condition; then_; else_ = branch else_ }
    | Unspecified -> Unspecified
    | _ -> sequence types (fst origin) (snd origin) first rest
  in
  reduce ~span [] task

let rec after (task : Value.t) result : Value.t =
  match task with
  | Primitive { primitive = Sequence; types; arguments = [ rest; first ]; owner; at } ->
      sequence types owner at { first with value = after first.value result } rest
  | Primitive { primitive = Make_task | Until_right; types = [ a; b; c ]; owner; at; _ } ->
      returned [ c; a; b ] result owner at
  | _ -> bug "a task that has ended was not running"

let rec name (task : Value.t) =
  match task with
  | Primitive { primitive = Sequence; arguments = [ _; first ]; owner; _ } -> (
      match head first.value with Ends _ -> owner | Runs _ | Passes -> name first.value)
  | Primitive { primitive = Return; _ } -> "ended"
  | Primitive { owner; _ } -> owner
  | _ -> bug "the name of a value that is not a task"

let rec place (task : Value.t) =
  match task with
  | Primitive { primitive = Sequence; arguments = [ _; first ]; at; _ } -> (
      match head first.value with Ends _ -> at | Runs _ | Passes -> place first.value)
  | Primitive { at; _ } -> at
  | _ -> bug "the place of a value that is not a task"

let rec next (task : Value.t) =
  match task with
  | Primitive { primitive = Sequence; arguments = [ rest; first ]; owner; at; _ } -> (
      match first.value with
      | Primitive { primitive = Sequence; _ } -> next first.value
      | _ -> (owner, place_of ~otherwise:at rest.value))
  | Primitive { owner; at; _ } -> (owner, at)
  | _ -> bug "the place of a value that is not a task"
