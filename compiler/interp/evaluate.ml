open Basis
open Core.Ir
module Variables = Map.Make (Stdlib.Int)

type program = {
  core : Core.Ir.program;
  real : Real.t;  (** the precision of [Float] *)
  console : control list;
  instances : Instance.table;
  definitions : (Global.t, definition) Hashtbl.t;
  values : (Global.t * ty list, Value.thunk) Hashtbl.t;
      (** values of definitions, by name and type arguments, which contain no variables *)
  floats : (Exact.t, float) Hashtbl.t;
      (** literals by their exact value, cached because rounding is slow *)
  nesting : Thunk.nesting;
}

type env = {
  program : program;
  types : ty Variables.t;  (** the types of the type variables in scope *)
  locals : Value.thunk Variables.t;
}

let bug format = Diagnostic.bug ~stage:"Interp" format

let program ?(params = []) (core : Core.Ir.program) =
  let definitions = Hashtbl.create 256 in
  List.iter (fun (d : definition) -> Hashtbl.replace definitions d.name d) core.definitions;
  let values = Hashtbl.create 256 in
  List.iter (fun (name, value) -> Hashtbl.replace values (name, []) value) params;
  {
    core;
    real = core.real;
    console = core.console;
    instances = Instance.table core.instances;
    definitions;
    values;
    floats = Hashtbl.create 64;
    nesting = Thunk.nesting ();
  }

(* {1 Types} Needed only for number literals and methods. *)

let rec closed types = function
  | Variable v as t -> Option.value ~default:t (Variables.find_opt v.id types)
  | (Bool | Int | Float | String | Size _) as t -> t
  | Tuple ts -> Tuple (List.map (closed types) ts)
  | Function (a, b) -> Function (closed types a, closed types b)
  | Signal_function (a, b) -> Signal_function (closed types a, closed types b)
  | Data (tycon, ts) -> Data (tycon, List.map (closed types) ts)
  | Array (size, element) -> Array (closed types size, closed types element)

let with_types (parameters : variable list) arguments types =
  List.fold_left2
    (fun types (v : variable) argument -> Variables.add v.id argument types)
    types parameters arguments

let rounded program value =
  match Hashtbl.find_opt program.floats value with
  | Some float -> float
  | None ->
      let float = Real.of_exact program.real value in
      Hashtbl.replace program.floats value float;
      float

let number env ty value : Value.t =
  let wrong () = bug "the number %s has an unexpected type" (Exact.to_string value) in
  match closed env.types ty with
  | Int -> ( match Exact.to_int32 value with Some n -> Int n | None -> wrong ())
  | Float -> Float (rounded env.program value)
  | Variable _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _ | Array _
  | Size _ ->
      wrong ()

(* {1 Expressions} *)

let bind (binder : binder) value env =
  { env with locals = Variables.add binder.local.id value env.locals }

let local env (x : Local.t) =
  match Variables.find_opt x.id env.locals with
  | Some value -> value
  | None -> bug "`%s` is not in scope" x.name

let is_true : Value.t -> bool = function
  | Bool b -> b
  | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      bug "a condition that is not a Bool"

let rec expr env (e : expr) : Value.t =
  Work.step ();
  match e.desc with
  | Local x -> Thunk.force (local env x)
  | Global (name, types) ->
      Thunk.force (global env.program name (List.map (closed env.types) types))
  | Primitive (p, types) -> primitive env p types []
  | Method { class_; name; ty; types } -> (
      let types = List.map (closed env.types) types in
      match Instance.method_ env.program.instances ~class_ ~name (closed env.types ty) with
      | Some (definition, first) -> Thunk.force (global env.program definition (first @ types))
      | None -> bug "no instance of `%s` for this type has the method `%s`" class_.name name)
  | Number value -> number env e.ty value
  | Boolean b -> Bool b
  | String text -> Text text
  | Lambda (binder, body) -> Function (fun argument -> expr (bind binder argument env) body)
  | Apply (f, argument) -> application env f [ argument ]
  | Let { binder; value; body } -> expr (bind binder (on_demand env value) env) body
  | Tuple parts -> Tuple (parts_on_demand env parts)
  | Array elements -> Array (parts_on_demand env elements)
  | Index (array, k) -> Arrays.element (expr env array) k
  | Component (value, index) -> (
      match expr env value with
      | Tuple parts -> Thunk.force parts.(index)
      | _ -> bug "a component of a value that is not a tuple")
  | Construct { data; _ } when Core.Console.is_console data -> Operator.at_rest env.program.console
  | Construct { constructor; arguments; data = _ } ->
      Data { constructor; arguments = parts_on_demand env arguments }
  | Is_constructor (value, constructor) -> (
      match expr env value with
      | Data data -> Bool (data.constructor = constructor)
      | _ -> bug "a constructor of a value that is not data")
  | Payload { value; constructor; field } -> (
      match expr env value with
      | Data data when data.constructor = constructor -> Thunk.force data.arguments.(field)
      | _ -> bug "the payload of another constructor")
  | If (condition, then_, else_) ->
      if is_true (expr env condition) then expr env then_ else expr env else_
  | Proc proc -> Signal_function (fun () -> start env proc)

and on_demand env (e : expr) =
  match e.desc with Local x -> local env x | _ -> Thunk.delay (fun () -> expr env e)

and parts_on_demand env parts = Array.map (on_demand env) (Array.of_list parts)

(* Applies [f] to [arguments], the arguments of all the applications around it, innermost first. *)
and application env (f : expr) arguments =
  match f.desc with
  | Apply (f, argument) -> application env f (argument :: arguments)
  | Primitive (p, types) -> primitive env p types (List.map (on_demand env) arguments)
  | _ -> apply (expr env f) (List.map (on_demand env) arguments)

and apply (f : Value.t) arguments =
  match (f, arguments) with
  | _, [] -> f
  | Function f, first :: others -> apply (f first) others
  | ( ( Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
      | Signal_function _ | Task _ | Ending _ ),
      _ ) ->
      bug "an applied value is not a function"

(* Applies a primitive to the arguments given so far. If there are fewer than its arity, the result
   is a function of the next argument. *)
and primitive env (p : Core.Primitive.t) types arguments : Value.t =
  match (p, arguments) with
  | Delay, [ initial ] -> Signal_function (fun () -> Stateful.delay initial)
  | Time, [] -> Signal_function (fun () -> Stateful.time env.program.real)
  | Time_since, [] ->
      Signal_function (fun () -> Stateful.time_since env.program.real env.program.nesting)
  | Step_time, [] -> Signal_function (fun () -> Stateful.step_time env.program.real)
  | Ticks, [ period ] -> Signal_function (fun () -> Stateful.ticks env.program.nesting period)
  | Integral, [] -> Signal_function (fun () -> Stateful.integral env.program.real)
  | Derivative, [] ->
      Signal_function (fun () -> Stateful.derivative env.program.real env.program.nesting)
  | (Switch | Delayed_switch), [ before; continuation ] ->
      let delayed = p = Delayed_switch in
      Signal_function (fun () -> Switching.switch env.program.nesting ~delayed before continuation)
  | (Recurring_switch | Delayed_recurring_switch), [ first ] ->
      let delayed = p = Delayed_recurring_switch in
      Signal_function (fun () -> Switching.recurring env.program.nesting ~delayed first)
  | Initially, [ choose ] ->
      Signal_function (fun () -> Switching.initially env.program.nesting choose)
  | On_event, [ body ] -> Signal_function (fun () -> Switching.on_event env.program.nesting body)
  | Make_task, [ signal_function ] -> Tasks.make signal_function
  | Until_right, [ signal_function ] -> Tasks.until_right signal_function
  | Return, [ result ] -> Task (Returns result)
  | Sequence, [ first; continuation ] -> Task (First (first, continuation))
  | Run_task, [ task ] -> Signal_function (fun () -> Tasks.run env.program.nesting task)
  | Map_sf, [ signal_function ] ->
      let size = size env types in
      Signal_function (fun () -> Arrays.map_sf ~size signal_function)
  | Parallel, [ all ] -> Signal_function (fun () -> Arrays.parallel all)
  | Reactimate, [ signal_function ] | Node, [ _; signal_function ] -> Thunk.force signal_function
  | Ending, [ signal_function ] -> (
      match List.map (closed env.types) types with
      | [ _; _; result ] -> Ending { signal_function; result }
      | _ -> bug "`ending` needs three type arguments")
  | _, _ -> (
      let arity = Core.Primitive_table.arity p in
      if List.length arguments < arity then
        Function (fun argument -> primitive env p types (arguments @ [ argument ]))
      else if List.length arguments > arity then
        let own = List.filteri (fun i _ -> i < arity) arguments in
        apply (primitive env p types own) (List.filteri (fun i _ -> i >= arity) arguments)
      else
        match (Arrays.apply apply p ~size:(size env types) arguments, p) with
        | Some value, _ -> value
        | None, Console kind ->
            Operator.apply env.program.console kind ~size:(size env types) arguments
        | None, Foreign f when Kernels.is_known f.symbol ->
            Foreign.apply env.program.core f arguments
        | None, _ -> Primitive.apply env.program.real p arguments)

(* The size of the array that a primitive returns: the primitive's last type argument. *)
and size env types = match List.rev_map (closed env.types) types with Size n :: _ -> n | _ -> 0

and global program name types =
  match Hashtbl.find_opt program.values (name, types) with
  | Some value -> value
  | None -> (
      match Hashtbl.find_opt program.definitions name with
      | None -> bug "`%s.%s` has no definition" name.module_ name.name
      | Some d ->
          let types_of_parameters = with_types d.parameters types Variables.empty in
          let env = { program; types = types_of_parameters; locals = Variables.empty } in
          let value = Thunk.equation program.nesting ~name:name.name (fun () -> expr env d.body) in
          Hashtbl.replace program.values (name, types) value;
          value)

(* {1 Signal functions} *)

(* The scope inside a proc, given its input and the outputs of its instances. The outputs are in the
   order of the instances' equations. *)
and inside env proc ~input outputs =
  let rec scope =
    lazy (fst (List.fold_left equation (bind proc.input input env, outputs) proc.equations))
  and equation (scope_so_far, outputs) { binder; rhs; span = _ } =
    match (rhs, outputs) with
    | Pure value, _ ->
        let evaluate () = expr (Lazy.force scope) value in
        let value = Thunk.equation env.program.nesting ~name:binder.local.name evaluate in
        (bind binder value scope_so_far, outputs)
    | Run _, output :: others -> (bind binder output scope_so_far, others)
    | Run _, [] -> bug "an instance without an output"
  in
  Lazy.force scope

and start env proc : Value.instance =
  let runs =
    List.filter_map
      (fun { rhs; _ } ->
        match rhs with
        | Run { signal_function; input } -> Some (signal_function, input)
        | Pure _ -> None)
      proc.equations
  in
  (* The signal function that an equation runs is a static expression: it may use other equations,
     but not signals. *)
  let signal = Thunk.delay (fun () -> bug "a signal is needed before the first instant") in
  let static = inside env proc ~input:signal (List.rev_map (fun _ -> signal) runs) in
  let instances =
    Long_list.map (fun (signal_function, input) -> (started static signal_function, input)) runs
  in
  let equation name evaluate = Thunk.equation env.program.nesting ~name evaluate in
  let output instant input =
    let rec scope = lazy (inside env proc ~input (Lazy.force outputs))
    and outputs =
      lazy
        (Long_list.map
           (fun ((instance : Value.instance), input) ->
             instance.output instant (equation proc.name (fun () -> expr (Lazy.force scope) input)))
           instances)
    in
    let scope = Lazy.force scope in
    equation proc.name (fun () -> expr scope proc.output)
  in
  let commit () = List.iter (fun ((i : Value.instance), _) -> i.commit ()) instances in
  { output; commit; successor = (fun () -> None) }

and started env signal_function =
  let value =
    Thunk.equation env.program.nesting ~name:"a signal function" (fun () ->
        expr env signal_function)
  in
  match Thunk.demand value with
  | Signal_function start -> start ()
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
  | Function _ | Task _ | Ending _ ->
      bug "an equation runs a value that is not a signal function"

let definition program name = global program name []

let written program name =
  match Hashtbl.find_opt program.definitions name with
  | None -> bug "`%s.%s` has no definition" name.module_ name.name
  | Some (d : definition) ->
      let env = { program; types = Variables.empty; locals = Variables.empty } in
      Thunk.equation program.nesting ~name:name.name (fun () -> expr env d.body)
