open Basis

let prelude name (e : Resolve.Ir.expr) =
  match e.desc with
  | Global g -> String.equal g.module_ "Prelude" && String.equal g.name name
  | _ -> false

let is_return (e : Resolve.Ir.expr) =
  match e.desc with Apply { head; style = Juxtaposed; _ } -> prelude "return" head | _ -> false

(* Does the task only return a value, in every case? *)
let rec only_returns (e : Resolve.Ir.expr) =
  is_return e
  ||
  match e.desc with
  | If { then_; else_; _ } -> only_returns then_ && only_returns else_
  | Apply
      { head = { desc = Apply { head; style = Juxtaposed; _ }; _ }; argument; style = Juxtaposed }
    ->
      prelude "whenT" head && only_returns argument
  | _ -> false

let warn ctx (statement : Resolve.Ir.expr) ~next =
  if only_returns statement then
    Context.warn ctx (Idle_return { statement; is_choice = not (is_return statement); next })

(* Is this a task whose result can have any type? Such a task never ends, unless an argument
   supplies the result. *)
let never_ends (ctx : Context.t) (e : Resolve.Ir.expr) =
  let head, arguments = Resolve.Walk.application e in
  let rec result taken (t : Type.t) = function
    | [] -> Some (taken, t)
    | _ :: others -> (
        match Type.expand t with
        | Function (parameter, t) -> result (parameter :: taken) t others
        | _ -> None)
  in
  let rec mentions v (t : Type.t) =
    match Type.expand t with
    | Flexible v' -> v == v'
    | Tuple ts | Data { arguments = ts; _ } -> List.exists (mentions v) ts
    | Function (a, b) | Signal_function (a, b) -> mentions v a || mentions v b
    | Rigid _ | Number _ | Bool | String | Size _ | Alias _ | Erroneous -> false
  in
  match head.desc with
  | Global g -> (
      match Resolve.Global_table.find_opt ctx.globals g with
      | None -> false
      | Some { scheme; _ } -> (
          let instance = Type.instantiate ctx.reader.supply ~depth:ctx.depth scheme in
          match result [] instance.ty arguments with
          | Some (taken, t) -> (
              match Type.expand t with
              | Data { tycon; arguments = [ input; output; x ]; _ } when tycon = Environment.task
                -> (
                  match Type.expand x with
                  | Flexible v -> not (List.exists (mentions v) (input :: output :: taken))
                  | _ -> false)
              | _ -> false)
          | None -> false))
  | _ -> false

let warn_of_end (ctx : Context.t) (e : Resolve.Ir.expr) ~next =
  match (next : Span.t option) with
  | Some next when never_ends ctx e ->
      Context.warn ctx
        (Unreachable_statement { at = next; endless = fst (Resolve.Walk.application e) })
  | Some _ | None -> ()
