open Ir

(* Whether a statement advances an integral. *)
let is_integral = function
  | Assign { place = Own value; value = Operation { operator = Add; arguments; _ }; _ } -> (
      match arguments with
      | [ Field before; Operation { operator = Multiply; arguments = [ Dt; Field _ ]; _ } ] ->
          before.id = value.id
      | _ -> false)
  | _ -> false

let reads_dt body =
  let found = ref false in
  let note = function Dt | Dt_nanoseconds -> found := true | _ -> () in
  Walk.expressions note (List.filter (fun s -> not (is_integral s)) body);
  !found

(* The modes that can take a step with the caller's dt in the node's first instant. *)
let first_modes (node : node) run =
  let numbers = ref [] in
  let note = function Enter { entry; _ } -> numbers := entry.mode :: !numbers | _ -> () in
  Walk.statements note node.reset.body;
  let is_first k = Option.is_some run.active || List.mem k !numbers in
  List.filteri (fun k _ -> is_first k) node.modes

let shows_in shows (node : node) =
  let found = ref (reads_dt node.step.body) in
  let step k = if shows.(k) then found := true in
  let statement = function
    | Step { node; _ } | Loop { node; _ } -> step node
    | Run run -> List.iter (fun (mode : mode) -> step mode.node) (first_modes node run)
    | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Return _ -> ()
  in
  Walk.statements statement node.step.body;
  !found

(* A delay of the node that is False in the first instant and True afterwards. *)
let delayed (node : node) =
  let becomes value body (field : field) =
    List.exists
      (function
        | Assign { place = Own f; value = Bool b; _ } -> f.id = field.id && Bool.equal b value
        | _ -> false)
      body
  in
  let is_mark field = becomes false node.reset.body field && becomes true node.step.body field in
  List.find_opt is_mark node.state

let own (node : node) =
  let fields = node.state @ List.concat_map State.fields_of_mode node.modes in
  let id = List.fold_left (fun most (field : field) -> max most (field.id + 1)) 0 fields in
  let content = Value Bool and purpose = State.past_first in
  { id; name = "started"; content; bound = None; purpose; origin = None; span = node.span }

let mark (root : node) =
  match delayed root with
  | Some field -> (root, { field; own = false })
  | None ->
      let field = own root in
      let unset = Assign { place = Own field; value = Bool false; span = root.span } in
      let reset = { root.reset with body = root.reset.body @ [ unset ] } in
      ({ root with state = root.state @ [ field ]; reset }, { field; own = true })

let program (program : program) =
  let last = Array.length program.nodes - 1 in
  let shows = Array.make (last + 1) false in
  Array.iteri
    (fun k (node : node) ->
      shows.(k) <-
        (match node.foreign with None -> shows_in shows node | Some _ -> node.state <> []))
    program.nodes;
  if not shows.(last) then program
  else
    let root, started = mark program.nodes.(last) in
    let nodes = Array.mapi (fun k node -> if k = last then root else node) program.nodes in
    { program with nodes; started = Some started }
