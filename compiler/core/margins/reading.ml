open Ir
module Int_map = Map.Make (Int)
module Global_table = Resolve.Global_table

exception Too_large

(* Maximum number of steps for reading and copying. Handwritten programs need a few dozen. *)
let most_steps = 10_000

type t = {
  definitions : definition Global_table.t;
  params : unit Global_table.t;
  instances : Instance.table;
  mutable last : int;
  mutable steps : int;
  mutable added : equation list; (* newest first *)
}

type env = {
  types : (variable * ty) list;
  values : value Int_map.t ref;
      (* mutable, because the equations of a proc may refer to each
                                   other *)
}

and value =
  | Expression of expr * env (* the variable is defined as this expression *)
  | Renamed of Local.t
  | Equation of equation * env (* an equation of the proc that is being analysed *)
  | Instance of instance (* an instance in a proc that the analysis has entered *)

and instance = {
  binder : binder;
  signal_function : expr;
  input : expr;
  inside : env;
  mutable copied : Local.t option;
}

type head = { env : env; expr : expr }

let rec least_id least (e : expr) =
  let least =
    match e.desc with
    | Lambda (b, _) | Let { binder = b; _ } -> min least b.local.id
    | Proc p ->
        List.fold_left
          (fun least (eq : equation) -> min least eq.binder.local.id)
          (min least p.input.local.id) p.equations
    | _ -> least
  in
  List.fold_left least_id least (Term.parts e)

let create (program : program) =
  let definitions = Global_table.create 256 and params = Global_table.create 16 in
  List.iter (fun (d : definition) -> Global_table.replace definitions d.name d) program.definitions;
  List.iter (fun (p : param) -> Global_table.replace params p.param ()) program.params;
  let last =
    List.fold_left (fun least (d : definition) -> least_id least d.body) 0 program.definitions
  in
  { definitions; params; instances = Instance.table program.instances; last; steps = 0; added = [] }

let fresh t name span : Local.t =
  t.last <- t.last - 1;
  { id = t.last; name; span }

let step t =
  t.steps <- t.steps + 1;
  if t.steps > most_steps then raise Too_large

let added t =
  let added = List.rev t.added in
  t.added <- [];
  added

let bind env (b : binder) value =
  { env with values = ref (Int_map.add b.local.id value !(env.values)) }

let meaning env (x : Local.t) = Int_map.find_opt x.id !(env.values)

let of_proc t (p : proc) =
  t.steps <- 0;
  let env = { types = []; values = ref Int_map.empty } in
  let add values (eq : equation) = Int_map.add eq.binder.local.id (Equation (eq, env)) values in
  env.values := List.fold_left add Int_map.empty p.equations;
  env

let enter env (p : proc) ~input =
  let inside = { env with values = ref Int_map.empty } in
  let value (eq : equation) =
    match eq.rhs with
    | Pure e -> Expression (e, inside)
    | Run { signal_function; input } ->
        Instance { binder = eq.binder; signal_function; input; inside; copied = None }
  in
  let add values (eq : equation) = Int_map.add eq.binder.local.id (value eq) values in
  let given = Int_map.add p.input.local.id (Expression (input.expr, input.env)) !(env.values) in
  inside.values := List.fold_left add given p.equations;
  inside

let ty env ty = if env.types = [] then ty else Erasure.substitute env.types ty

(* The definition of a method, if the type is already known. *)
let method_ t env (e : expr) =
  match e.desc with
  | Method { class_; name; ty = of_; types } -> (
      let of_ = ty env of_ and types = List.map (ty env) types in
      match Instance.find t.instances ~class_ ~name of_ types with
      | Some (g, types) -> Global (g, types)
      | None -> Method { class_; name; ty = of_; types })
  | desc -> desc

let rec head t ~stop env (e : expr) =
  step t;
  let itself = { env; expr = e } in
  match method_ t env e with
  | Local x -> (
      match meaning env x with
      | Some (Expression (e, env)) -> head t ~stop env e
      | Some (Equation ({ rhs = Pure e; _ }, env)) -> head t ~stop env e
      | Some (Equation _ | Instance _ | Renamed _) | None -> itself)
  | Global (g, types) -> (
      match Global_table.find_opt t.definitions g with
      | Some d when not (stop g || Global_table.mem t.params g) ->
          let types = List.combine d.parameters (List.map (ty env) types) in
          head t ~stop { types; values = ref Int_map.empty } d.body
      | Some _ | None -> itself)
  | Apply (f, a) -> (
      match head t ~stop env f with
      | { env = inside; expr = { desc = Lambda (b, body); _ } } ->
          head t ~stop (bind inside b (Expression (a, env))) body
      | _ -> itself)
  | Let { binder; value; body } -> head t ~stop (bind env binder (Expression (value, env))) body
  | Component (value, k) -> (
      match head t ~stop env value with
      | { env; expr = { desc = Tuple parts; _ } } -> head t ~stop env (List.nth parts k)
      | _ -> itself)
  | Payload { value; constructor; field } -> (
      match head t ~stop env value with
      | { env; expr = { desc = Construct c; _ } } when c.constructor = constructor ->
          head t ~stop env (List.nth c.arguments field)
      | _ -> itself)
  | _ -> itself

let run _ env x =
  match meaning env x with
  | Some (Equation ({ rhs = Run { signal_function; _ }; _ }, env)) ->
      Some { env; expr = signal_function }
  | Some (Instance i) -> Some { env = i.inside; expr = i.signal_function }
  | Some (Equation _ | Expression _ | Renamed _) | None -> None

let input _ env x =
  match meaning env x with
  | Some (Equation ({ rhs = Run { input; _ }; _ }, env)) -> Some { env; expr = input }
  | Some (Instance i) -> Some { env = i.inside; expr = i.input }
  | Some (Equation _ | Expression _ | Renamed _) | None -> None

let rec copy t env (e : expr) : expr =
  step t;
  let made desc = { e with desc; ty = ty env e.ty } in
  match method_ t env e with
  | Local x -> (
      match meaning env x with
      | Some (Expression (e, env)) -> copy t env e
      | Some (Renamed y) -> made (Local y)
      | Some (Equation _) | None -> made (Local x)
      | Some (Instance i) -> made (Local (copied t i)))
  | Global (g, types) -> made (Global (g, List.map (ty env) types))
  | Primitive (p, types) -> made (Primitive (p, List.map (ty env) types))
  | Method _ as desc -> made desc
  | Lambda (b, body) ->
      let b, env = rename t env b in
      made (Lambda (b, copy t env body))
  | Let { binder; value; body } ->
      let value = copy t env value in
      let binder, env = rename t env binder in
      made (Let { binder; value; body = copy t env body })
  | Proc p ->
      let input, env = rename t env p.input in
      let env, binders =
        List.fold_left_map
          (fun env (eq : equation) ->
            let binder, env = rename t env eq.binder in
            (env, binder))
          env p.equations
      in
      let equation (eq : equation) binder =
        let rhs =
          match eq.rhs with
          | Pure e -> Pure (copy t env e)
          | Run { signal_function; input } ->
              Run { signal_function = copy t env signal_function; input = copy t env input }
        in
        { eq with binder; rhs }
      in
      let equations = List.map2 equation p.equations binders in
      made (Proc { p with input; equations; output = copy t env p.output })
  | _ -> made (Term.with_parts (copy t env) e)

and rename t env (b : binder) =
  let local = fresh t b.local.name b.local.span in
  ({ local; ty = ty env b.ty }, bind env b (Renamed local))

and copied t (i : instance) =
  match i.copied with
  | Some local -> local
  | None ->
      let { local; ty = given } = i.binder in
      (* without a name, so that it is not a visible signal *)
      let local = fresh t "" local.span in
      i.copied <- Some local;
      let rhs =
        let signal_function = copy t i.inside i.signal_function in
        Run { signal_function; input = copy t i.inside i.input }
      in
      let binder = { local; ty = ty i.inside given } in
      t.added <- { binder; rhs; span = local.span } :: t.added;
      local
