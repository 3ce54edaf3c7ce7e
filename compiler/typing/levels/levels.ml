open Basis
open Ir

(* An expression that must not depend on the signals of the enclosing proc. Signals from outside
   that proc are captured, so they are static here. [depth]: depth of the expression. [proc_depth]:
   depth of the proc. Each region is reported at most once. *)
type region = { depth : int; proc_depth : int; kind : kind; mutable reported : bool }

and kind =
  | Head of { head : expr; input : expr }
  | Binding_of of Local.t  (** a signal function *)
  | Binding_of_task of Local.t

type place = {
  position : Misplaced.position;
  depth : int;
  proc_depth : int;
  regions : region list;  (** innermost first *)
  conditional : pattern list;
      (** patterns bound inside the code that does not run at every instant, innermost first *)
  lifted : bool;
      (** inside a local function that is lifted to a separate definition and therefore cannot
          contain instances *)
}

type walk = {
  sink : Diagnostic.sink;
  graph : Level_graph.t;
  constants : Constant_index.constants;
  definition : Global.t;
  within : expr;  (** the value of the definition *)
  sources : Source.t;
  values : (int, expr) Hashtbl.t;  (** the value of each local variable, by its [id] *)
  memory : Memory.t;
}

let enter place kind =
  {
    place with
    regions =
      { depth = place.depth; proc_depth = place.proc_depth; kind; reported = false }
      :: place.regions;
  }

(* {1 Values that must be static} *)

let rec runs_a_local (h : expr) =
  match h.desc with Local _ -> true | Apply (f, _) -> runs_a_local f | _ -> false

let complaint kind what =
  match kind with
  | Head { head = { desc = Apply ({ desc = Primitive ({ name = "delay"; _ }, _); _ }, _); _ }; _ }
    ->
      Printf.sprintf "the initial value of `delay` must be static, but %s" what
  | Head { head = { desc = Apply _; _ } as h; _ } when not (runs_a_local h) ->
      Printf.sprintf "the arguments of %s before its signal must be static, but %s"
        (Misplaced.name h) what
  | Head _ -> Printf.sprintf "the signal function that runs here must be static, but %s" what
  | Binding_of x ->
      Printf.sprintf "`%s` is a signal function and must be static, but %s" x.name what
  | Binding_of_task x -> Printf.sprintf "`%s` is a task and must be static, but %s" x.name what

(* The hint for an argument of a signal function that is not static. *)
let for_arguments w head input =
  let value (x : Local.t) = Hashtbl.find_opt w.values x.id in
  match Settings.hint w.sources ~value ~head ~input with
  | Some hint -> hint
  | None when runs_a_local head ->
      "static values are known when it starts: pass a signal in its input, or use `initially` to \
       start it with the first value of a signal"
  | None ->
      "static values are known when it starts: run one for each of a few constant settings and \
       choose between their outputs, pass the signal in the input, or use `initially` to keep its \
       first value"

(* `delay x 0`, with the arguments in the wrong order *)
let exchanged_delay w (start : expr) (input : expr) =
  let quote e = Option.map Source.grouped (Settings.quote w.sources e) in
  match (quote start, quote input) with
  | Some x, Some constant when Settings.is_constant input ->
      let text = Printf.sprintf "delay %s %s" constant x in
      Some
        (fun d ->
          Diagnostic.hint
            (Printf.sprintf "the initial value comes before the signal: write `%s`" text)
            d
          |> Diagnostic.fix
               (Printf.sprintf "write `%s`" text)
               [ (start.span, constant); (input.span, x) ])
  | _ -> None

(* A hint that guesses what the programmer meant. *)
let cure w = function
  | Head
      {
        head = { desc = Apply ({ desc = Primitive ({ name = "delay"; _ }, _); _ }, start); _ };
        input;
      }
    when exchanged_delay w start input <> None ->
      Option.get (exchanged_delay w start input)
  | Head { head = { desc = Apply ({ desc = Primitive ({ name = "delay"; _ }, _); _ }, _); _ }; _ }
    ->
      Diagnostic.hint
        "write a constant, as in `delay 0 x`; to start with the first value of `x` instead, write \
         `previous x`, with `import Control`"
  | Head { head = { desc = If _ | Case _; _ }; _ } ->
      Diagnostic.hint "run each in a separate equation, and choose between their outputs"
  | Head
      {
        head =
          { desc = Apply ({ desc = Apply ({ desc = Primitive ({ name; _ }, _); _ }, _); _ }, _); _ };
        _;
      }
    when name = "switch" || name = "dSwitch" ->
      Diagnostic.hint (Printf.sprintf "pass it in the event of the `%s`, or use `initially`" name)
  | Binding_of_task _ ->
      Diagnostic.hint
        "pass values that are known at the start as parameters of the task, and signals in its \
         input"
  | Head { head; input } -> Diagnostic.hint (for_arguments w head input)
  | Binding_of x ->
      Diagnostic.hint
        (Printf.sprintf
           "pass signals in its input: `%s` can take a pair, `proc (x, y) -> …`; to pass a value \
            from one mode to the next, use the event of the switch"
           x.name)

let code = function Head _ -> "E0340" | Binding_of _ | Binding_of_task _ -> "E0344"

let report w region ~at what explain =
  if not region.reported then (
    region.reported <- true;
    Diagnostic.(
      error ~code:(code region.kind) ~at "%s" (complaint region.kind what)
      |> explain |> cure w region.kind |> emit w.sink))

let outermost suits regions =
  List.fold_left (fun found r -> if suits r then Some r else found) None regions

let mention w place (x : Local.t) (e : expr) =
  match Level_graph.find w.graph x with
  | None -> ()
  | Some node -> (
      match (Level_graph.level node, Level_graph.origin node) with
      | (Constant | Static), _ | Signal, Bound_signal_function -> ()
      | Signal, (Derived | Parameter | Input) -> (
          let bound_at = Level_graph.depth node in
          let concerned (r : region) = r.proc_depth <= bound_at && bound_at <= r.depth in
          match outermost concerned place.regions with
          | None -> ()
          | Some region ->
              report w region ~at:e.span
                (Printf.sprintf "`%s` is a signal" x.name)
                (Level_graph.explain x node)))

(* {1 Places of instances} *)

(* A variable of the expression that does not have a value at every instant. *)
let bound_here place e =
  let found = ref None in
  let bound (e : expr) =
    match e.desc with
    | Local (x, _) when List.exists (fun p -> List.memq x (Parts.variables p)) place.conditional ->
        found := Some x;
        true
    | _ -> false
  in
  if place.conditional <> [] then ignore (Parts.exists bound e);
  !found

let obstacle w place (e : expr) head : Misplaced.obstacle option =
  match (place.position, bound_here place e) with
  | Every_instant, _ -> None
  | (Outside | In_task), _ -> Some Depends_on_start
  | _, Some x -> Some (Bound_here x)
  | _ when place.lifted -> Some Lifted
  | _ when Misplaced.runs head w.definition -> Some Own_definition
  | _ -> if Memory.remembers w.memory head then Some Depends_on_start else None

(* Checks the places of the head and of the input. An instance is reported at most once. A stateless
   signal function runs at every instant, wherever it occurs in its proc. *)
let instance w place (e : expr) head input =
  let region around = outermost (fun (r : region) -> r.depth >= around) place.regions in
  let nothing_runs region =
    report w region ~at:e.span (Printf.sprintf "%s runs here" (Misplaced.name head)) Fun.id;
    (place, place)
  in
  match region place.depth with
  | Some region -> nothing_runs region
  | None -> (
      match obstacle w place e head with
      | Some obstacle ->
          Misplaced.report w.sink w.sources ~definition:w.definition ~within:w.within place.position
            obstacle e ~head ~input;
          (place, place)
      | None -> (
          match region place.proc_depth with
          | Some region -> nothing_runs region
          | None ->
              let place =
                { place with position = Every_instant; depth = place.proc_depth; conditional = [] }
              in
              (enter place (Head { head; input }), place)))

let conditional place (position : Misplaced.position) =
  match place.position with
  | Every_instant -> { place with position }
  | In_branch (Some _) -> { place with position = In_branch None }
  | Outside | In_task | In_branch None | In_guard | In_function _ -> place

(* [f]: the function in an application, possibly the [do] primitive applied to its first task. *)
let in_task place (f : expr) =
  match f.desc with
  | Apply ({ desc = Primitive (g, _); _ }, _)
    when place.position = Outside && g = Environment.sequence ->
      { place with position = In_task }
  | _ -> place

let knowing place patterns =
  match place.position with
  | Outside | In_task | Every_instant -> place
  | In_branch _ | In_guard | In_function _ ->
      { place with conditional = List.rev_append patterns place.conditional }

(* {1 The index of an array} *)

let not_constant w ?array (e : expr) problem =
  let error at format = Diagnostic.error ~code:"E0347" ~at format in
  let index = match e.desc with Local (x, _) -> x.name | Global (g, _) -> g.name | _ -> "i" in
  (match (problem : Constant_index.problem) with
  | Variable (x, at) ->
      error at "the index of `!` must be constant, but `%s` is not" x.name
      |> Diagnostic.label ~at:x.span (Printf.sprintf "`%s` is bound here" x.name)
  | Param (p, at) ->
      error at
        "the index of `!` must be constant, but the parameter `%s` is only known when the program \
         starts"
        p.name
  | Computed at when Span.compare at e.span = 0 -> error at "the index of `!` must be constant"
  | Computed at ->
      error e.span "the index of `!` must be constant" |> Diagnostic.label ~at "this is computed")
  |> Diagnostic.note "an index can be a number, a name of a number, or arithmetic with these"
  |> Diagnostic.hint
       (let quoted = Option.bind array (fun (a : expr) -> Source.quote w.sources a.span) in
        let index = Option.value (Source.quote w.sources e.span) ~default:index in
        let missing =
          match Option.map (fun (a : expr) -> a.ty) array with
          | Some (Data { arguments = [ _; Number _ ]; _ }) -> "0"
          | Some (Data { arguments = [ _; Bool ]; _ }) -> "False"
          | _ -> "x"
        in
        match quoted with
        | Some array when String.length array + String.length index < 60 ->
            Printf.sprintf
              "use `at %s %s %s`, which takes any index, and returns `%s` if there is no such \
               element"
              (Source.grouped index) missing (Source.grouped array) missing
        | _ ->
            Printf.sprintf
              "use `at %s x xs`, which takes any index, and returns `x` if there is no such element"
              (Source.grouped index))
  |> Diagnostic.emit w.sink

let outside w (array : expr) (index : expr) k =
  let error format = Diagnostic.error ~code:"E0332" ~at:index.span format in
  match array.ty with
  | Data { arguments = [ Size n; _ ]; _ } when k >= n || k < 0 ->
      error "index %d is outside of an array of %d elements" k n
      |> Diagnostic.label ~at:array.span (Printf.sprintf "this is `%s`" (Show.ty array.ty))
      |> Diagnostic.hint
           (if n = 1 then "its only element has the index 0"
            else Printf.sprintf "the indices are from 0 to %d" (n - 1))
      |> Diagnostic.emit w.sink
  | _ when k < 0 ->
      error "index %d is outside of every array" k
      |> Diagnostic.hint "the indices start at 0"
      |> Diagnostic.emit w.sink
  | _ -> ()

let index w (array : expr) (k : expr) =
  match Constant_index.value w.constants k with
  | Ok n ->
      let n = Int32.to_int n in
      outside w array k n;
      n
  | Error problem ->
      not_constant w ~array k problem;
      0

(* {1 The walk} *)
(* A pattern that binds no variable has no node. Its level does not matter, so this is a
   conservative guess. *)
let level w place (p : pattern) =
  match List.find_map (Level_graph.find w.graph) (Parts.variables p) with
  | Some node -> Level_graph.level node
  | None -> ( match place.position with Outside | In_task -> Static | _ -> Signal)

let remember w (b : binding) =
  match b.pattern.desc with Bound x -> Hashtbl.replace w.values x.id b.value | _ -> ()

(* Shares unchanged subexpressions, because large programs contain very many and most of them do not
   change. *)
let rec expr w place (e : expr) : expr =
  let with_ desc : expr = { e with desc } in
  match e.desc with
  | Local (x, _) ->
      mention w place x e;
      e
  | Primitive ({ name = "!"; _ }, _) ->
      not_constant w e (Computed e.span);
      e
  | Global _ | Primitive _ | Method _ | Constructor _ | Number _ | String _ -> e
  | Tuple es -> several w place e es (fun es -> Tuple es)
  | Array es -> several w place e es (fun es -> Array es)
  | Apply ({ desc = Apply ({ desc = Primitive ({ name = "!"; _ }, _); _ }, array); _ }, k) ->
      with_ (Index (expr w place array, index w array k))
  | Index (array, k) -> one w place e array (fun array -> Index (array, k))
  | Apply (f, a) ->
      let place = in_task place f in
      let f' = expr w place f in
      let a' = expr w place a in
      if f' == f && a' == a then e else with_ (Apply (f', a'))
  | Run (h, input) ->
      let place_of_head, place = instance w place e h input in
      let head = expr w place_of_head h in
      let input' = expr w place input in
      if head == h && input' == input then e else with_ (Run (head, input'))
  | Negate a -> one w place e a (fun a -> Negate a)
  | Power (a, k) -> one w place e a (fun a -> Power (a, k))
  | Field (a, c, i) -> one w place e a (fun a -> Field (a, c, i))
  | If (condition, a, b) -> choice w place e condition a b
  | Case (scrutinee, branches) -> case w place e scrutinee branches
  | Let (bindings, body) ->
      List.iter (Memory.local w.memory) bindings;
      List.iter (remember w) bindings;
      let bind place (b : binding) = (knowing place [ b.pattern ], binding w place b) in
      let place, bindings' = List.fold_left_map bind place bindings in
      let body' = expr w place body in
      if List.for_all2 ( == ) bindings' bindings && body' == body then e
      else with_ (Let (bindings', body'))
  | Lambda (patterns, body) -> lambda w place "" e patterns body
  | Guards (guarded, last) -> guards w place e guarded last
  | Proc { input; equations; output } -> proc w place e input equations output
  | Record (c, fields) ->
      let fields' = Long_list.map_sharing (field w place) fields in
      if fields' == fields then e else with_ (Record (c, fields'))
  | Update (record, c, fields) ->
      let record' = expr w place record in
      let fields' = Long_list.map_sharing (field w place) fields in
      if record' == record && fields' == fields then e else with_ (Update (record', c, fields'))

and choice w place e condition a b =
  let condition' = expr w place condition in
  let branch chosen_if =
    expr w (conditional place (In_branch (Some { test = condition; chosen_if })))
  in
  let a' = branch true a in
  let b' = branch false b in
  if condition' == condition && a' == a && b' == b then e
  else { e with desc = If (condition', a', b') }

and case w place e scrutinee branches =
  let scrutinee' = expr w place scrutinee in
  let place = conditional place (In_branch None) in
  let branch (b : branch) =
    let value = expr w (knowing place [ b.pattern ]) b.value in
    if value == b.value then b else { b with value }
  in
  let branches' = Long_list.map_sharing branch branches in
  if scrutinee' == scrutinee && branches' == branches then e
  else { e with desc = Case (scrutinee', branches') }

and guards w place e guarded last =
  let in_guard = conditional place In_guard and in_branch = conditional place (In_branch None) in
  let alternative ((guard, value) as unchanged) =
    let guard' = expr w in_guard guard in
    let value' = expr w in_branch value in
    if guard' == guard && value' == value then unchanged else (guard', value')
  in
  let guarded' = Long_list.map_sharing alternative guarded in
  let last' = Option.map (expr w in_branch) last in
  if guarded' == guarded && Option.equal ( == ) last' last then e
  else { e with desc = Guards (guarded', last') }

and proc w place e input equations output =
  let depth = place.depth + 1 in
  let place =
    {
      place with
      position = Every_instant;
      depth;
      proc_depth = depth;
      conditional = [];
      lifted = false;
    }
  in
  List.iter (Memory.local w.memory) equations;
  List.iter (remember w) equations;
  let equations' = Long_list.map_sharing (binding w place) equations in
  let output' = expr w place output in
  if equations' == equations && output' == output then e
  else { e with desc = Proc { input; equations = equations'; output = output' } }

and one w place e part make =
  let part' = expr w place part in
  if part' == part then e else { e with desc = make part' }

and several w place e parts make =
  let parts' = Long_list.map_sharing (expr w place) parts in
  if parts' == parts then e else { e with desc = make parts' }

and field w place ((i, e) as unchanged) =
  let e' = expr w place e in
  if e' == e then unchanged else (i, e')

and lambda w place name e patterns body =
  let body' = function_ w place name patterns body in
  if body' == body then e else { e with desc = Lambda (patterns, body') }

and function_ w place name patterns body =
  let position : Misplaced.position =
    match place.position with
    | (Outside | In_task) as position -> position
    | Every_instant | In_branch _ | In_guard | In_function _ -> In_function name
  in
  expr w (knowing { place with position; depth = place.depth + 1 } patterns) body

and binding w place (b : binding) =
  let level = level w place b.pattern in
  let is_lifted =
    b.scheme.types <> [] || b.scheme.representations <> []
    || (b.recursive && Parts.is_static b.scheme.ty)
  in
  let place = if is_lifted then { place with lifted = true } else place in
  let value =
    match (b.pattern.desc, b.pattern.ty, b.value.desc) with
    | Bound x, _, Lambda (patterns, body) -> lambda w place x.name b.value patterns body
    | Bound x, Signal_function _, _ -> expr w (enter place (Binding_of x)) b.value
    | Bound x, Data { tycon; _ }, _ when tycon = Environment.task ->
        expr w (enter place (Binding_of_task x)) b.value
    | _ -> expr w place b.value
  in
  (match (level, b.pattern.desc, b.pattern.ty) with
  | Constant, Bound x, Number _ -> Constant_index.local w.constants x b.value
  | _ -> ());
  if level = b.level && value == b.value then b else { b with level; value }

let top_level =
  { position = Outside; depth = 1; proc_depth = 0; regions = []; conditional = []; lifted = false }

let program ?(sources = Source.create ()) sink (p : program) =
  let constants = Constant_index.create p.params and memory = Memory.create p in
  (* Each variable occurs in one definition only, so each definition has its own graph. *)
  let definition (d : definition) =
    let graph = Level_dependencies.definition sink d in
    Level_graph.solve graph;
    let values = Hashtbl.create 16 in
    let w =
      { sink; graph; constants; definition = d.name; within = d.value; sources; values; memory }
    in
    (match d.value.ty with Number _ -> Constant_index.global constants d.name d.value | _ -> ());
    let value = expr w top_level d.value in
    if value == d.value then d else { d with value }
  in
  { p with definitions = Long_list.map definition p.definitions }
