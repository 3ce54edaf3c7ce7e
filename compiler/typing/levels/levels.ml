open Basis
open Ir

(* An expression that must not depend on the signals of the enclosing proc. Signals from outside
   that proc are captured, so they are static here. [depth]: depth of the expression. [proc_depth]:
   depth of the proc. Each region is reported at most once. *)
type region = {
  depth : int;
  proc_depth : int;
  must_be_static : Level_fact.region;
  mutable reported : bool;
}

type place = {
  position : Level_fact.position;
  depth : int;
  proc_depth : int;
  regions : region list;  (** innermost first *)
  conditional : pattern list;
      (** patterns bound in enclosing code that does not run at every instant, innermost first *)
  lifted : bool;
      (** whether the code is in a local function that is lifted to a separate definition and
          therefore cannot contain instances *)
}

type walk = {
  facts : Fact.t Facts.t;
  graph : Level_graph.t;
  constants : Constant_index.constants;
  definition : Global.t;
  within : expr;  (** the value of the definition *)
  values : (int, expr) Hashtbl.t;  (** the value of each local variable, by its [id] *)
  memory : Memory.t;
}

let report w fact = Facts.report w.facts (Level fact)

let enter place must_be_static =
  {
    place with
    regions =
      { depth = place.depth; proc_depth = place.proc_depth; must_be_static; reported = false }
      :: place.regions;
  }

(* {1 Values that must be static} *)

let not_static w (region : region) ~at cause =
  if not region.reported then (
    region.reported <- true;
    report w (Not_static { at; region = region.must_be_static; cause }))

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
          | Some region -> not_static w region ~at:e.span (Mentions (x, Level_graph.reasons x node))
          ))

(* {1 Places of instances} *)

(* A variable in the expression that does not have a value at every instant. *)
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

let rec runs (h : expr) definition =
  match h.desc with
  | Global (g, _) -> g = definition
  | Apply (f, _) -> runs f definition
  | _ -> false

let obstacle w place (e : expr) head : Level_fact.obstacle option =
  match (place.position, bound_here place e) with
  | Every_instant, _ -> None
  | (Outside | In_task), _ -> Some Depends_on_start
  | _, Some x -> Some (Bound_here x)
  | _ when place.lifted -> Some Lifted
  | _ when runs head w.definition -> Some Own_definition
  | _ -> if Memory.remembers w.memory head then Some Depends_on_start else None

(* Checks the place of an instance, and returns the places of its head and its input. Reports an
   instance at most once. A stateless signal function runs at every instant, wherever it occurs in
   its proc. *)
let instance w place (e : expr) head input =
  let region around = outermost (fun (r : region) -> r.depth >= around) place.regions in
  let nothing_runs region =
    not_static w region ~at:e.span (Runs head);
    (place, place)
  in
  match region place.depth with
  | Some region -> nothing_runs region
  | None -> (
      match obstacle w place e head with
      | Some obstacle ->
          let { definition; within; _ } = w and { position; _ } = place in
          report w (Misplaced { definition; within; position; obstacle; instance = e; head; input });
          (place, place)
      | None -> (
          match region place.proc_depth with
          | Some region -> nothing_runs region
          | None ->
              let place =
                { place with position = Every_instant; depth = place.proc_depth; conditional = [] }
              in
              let value (x : Local.t) = Hashtbl.find_opt w.values x.id in
              (enter place (Head { head; input; value }), place)))

let conditional place (position : Level_fact.position) =
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

let check_size w (array : expr) index value =
  let outside size = report w (Index_outside { array; index; value; size }) in
  match array.ty with
  | Data { arguments = [ Size n; _ ]; _ } when value >= n || value < 0 -> outside (Some n)
  | _ -> if value < 0 then outside None

let index w (array : expr) (k : expr) =
  match Constant_index.value w.constants k with
  | Ok n ->
      let n = Int32.to_int n in
      check_size w array k n;
      n
  | Error problem ->
      report w (Index_not_constant { index = k; array = Some array; problem });
      0

(* {1 The walk} *)

(* A pattern that does not bind any variable has no node. Its level does not matter; this function
   returns a conservative one. *)
let level w place (p : pattern) =
  match List.find_map (Level_graph.find w.graph) (Parts.variables p) with
  | Some node -> Level_graph.level node
  | None -> ( match place.position with Outside | In_task -> Static | _ -> Signal)

let remember w (b : binding) =
  match b.pattern.desc with Bound x -> Hashtbl.replace w.values x.id b.value | _ -> ()

(* Shares unchanged subexpressions, because large programs contain very many subexpressions, most of
   which do not change. *)
let rec expr w place (e : expr) : expr =
  let with_ desc : expr = { e with desc } in
  match e.desc with
  | Local (x, _) ->
      mention w place x e;
      e
  | Primitive ({ name = "!"; _ }, _) ->
      report w (Index_not_constant { index = e; array = None; problem = Computed e.span });
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
  let position : Level_fact.position =
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

let program facts (p : program) =
  let constants = Constant_index.create p.params and memory = Memory.create p in
  (* Each variable occurs in one definition only, so each definition has its own graph. *)
  let definition (d : definition) =
    let graph = Level_dependencies.definition facts d in
    Level_graph.solve graph;
    let values = Hashtbl.create 16 in
    let w = { facts; graph; constants; definition = d.name; within = d.value; values; memory } in
    (match d.value.ty with Number _ -> Constant_index.global constants d.name d.value | _ -> ());
    let value = expr w top_level d.value in
    if value == d.value then d else { d with value }
  in
  { p with definitions = Long_list.map definition p.definitions }
