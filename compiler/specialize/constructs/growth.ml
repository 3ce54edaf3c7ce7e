open Basis

type t = {
  head : int list; (* ids of the code that the mode runs first *)
  depth : int;
  added : string; (* the outermost function in the mode's deepest nesting *)
  name : string;
  at : Span.t;
  from : t option;
  steps : int; (* number of consecutive growth steps *)
  waiting : Span.t option;
      (* for a task: the continuation that occurs most often among those waiting for the task to
         end *)
  task : string option; (* for a task: the name of the definition that contains it *)
}

let deepest nests =
  List.fold_left (fun (n, name) (m, other) -> if m > n then (m, other) else (n, name)) (0, "") nests

(* The name to show for a function chosen by an [if]. *)
let an_if = "if"

(* How deeply functions are nested in the captured variables of other functions, and the name of the
   outermost function. [known]: results by closure, because values may share a closure. *)
let rec nest known (value : Value.t) =
  Work.step ();
  match value with
  | Function closure | Signal_function closure -> (
      match Variables.Table.find_opt known closure.identity with
      | Some nest -> nest
      | None ->
          let nest = (1 + fst (inside known closure), closure.name) in
          Variables.Table.replace known closure.identity nest;
          nest)
  | Primitive { arguments; _ } ->
      deepest (List.map (fun (a : Value.argument) -> nest known a.value) arguments)
  | Product values -> deepest (List.map (nest known) (Array.to_list values))
  | Elements values | Constructed { arguments = values; _ } ->
      deepest (List.map (nest known) values)
  | Choice { then_; else_; _ } -> (1 + fst (deepest [ nest known then_; nest known else_ ]), an_if)
  | Program value -> nest known value
  | Atom _ | Text _ | Array _ | Unspecified -> (0, "")

and inside known (closure : Value.closure) =
  Variables.fold
    (fun _ (entry : Value.entry) deeper -> deepest [ deeper; nest known (Closure.forced entry) ])
    closure.captured (0, "")

(* Like {!nest}, but for a mode's signal function. Does not count the mode's own code. *)
let rec nest_of_mode known (value : Value.t) =
  match value with
  | Primitive { primitive = Sequence; arguments; owner; _ } ->
      (* the continuation after the running task *)
      let depth, name =
        deepest (List.map (fun (a : Value.argument) -> nest_of_mode known a.value) arguments)
      in
      (1 + depth, if depth = 0 then owner else name)
  | Function closure | Signal_function closure -> inside known closure
  | Primitive { arguments; _ } ->
      deepest (List.map (fun (a : Value.argument) -> nest_of_mode known a.value) arguments)
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Choice _ | Program _
  | Unspecified ->
      (0, "")

let rec name_of : Value.t -> string = function
  | Primitive { primitive = Run_task; arguments = [ task ]; _ } -> name_of task.value
  | Function closure | Signal_function closure -> closure.name
  | Primitive { owner; _ } -> owner
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Choice _ | Program _
  | Unspecified ->
      ""

let rec head (value : Value.t) =
  match value with
  | Primitive { primitive = Sequence; arguments = [ _; first ]; _ } -> head first.value
  | Function closure | Signal_function closure -> [ Closure.code_id closure.code ]
  | Primitive { arguments; _ } ->
      List.concat_map (fun (a : Value.argument) -> head a.value) arguments
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Choice _ | Program _
  | Unspecified ->
      []

(* The most recent mode with this head: [t] or one of the [steps] modes before it. *)
let rec before head t steps =
  match t with
  | None -> None
  | Some t when t.head = head -> Some t
  | Some t -> if steps = 0 then None else before head t.from (steps - 1)

(* After this many consecutive growth steps, growth is assumed to be endless. *)
let most_steps = 20

(* The continuation that occurs most often among those that wait for the running task, if it occurs
   often enough. If several occur equally often, returns the innermost of them. *)
let waiting (value : Value.t) =
  let rec all found (value : Value.t) =
    match value with
    | Primitive { primitive = Run_task; arguments = [ task ]; _ } -> all found task.value
    | Primitive { primitive = Sequence; arguments = [ rest; first ]; _ } -> (
        match rest.value with
        | Function { code = Lambda (_, body) as code; _ } ->
            all ((Closure.code_id code, body.span) :: found) first.value
        | _ -> all found first.value)
    | _ -> found
  in
  let innermost_first = all [] value in
  let count id = List.length (List.filter (fun (other, _) -> other = id) innermost_first) in
  let most best (id, place) =
    match best with
    | Some (n, _) when count id <= n -> best
    | Some _ | None -> Some (count id, place)
  in
  match List.fold_left most None innermost_first with
  | Some (n, place) when n >= most_steps / 2 -> Some place
  | Some _ | None -> None

let of_value value ~at ~from =
  let head = head value in
  let depth, added = nest_of_mode (Variables.Table.create 16) value in
  let steps =
    match before head from 50 with
    | Some earlier when depth > earlier.depth -> earlier.steps + 1
    | Some _ | None -> 0
  in
  let waiting = if steps > most_steps then waiting value else None in
  let name = name_of value in
  let task = match value with Primitive { primitive = Run_task; _ } -> Some name | _ -> None in
  { head; depth; added; name; at; from; steps; waiting; task }

let is_endless t = t.steps > most_steps

(* The modes since the last mode with the same code, in order. *)
let since t =
  let rec go found = function
    | Some earlier when earlier.head <> t.head -> go (earlier :: found) earlier.from
    | Some _ | None -> found
  in
  go [] t.from

(* The nearest place outside the library. *)
let rec in_program c (t : t) =
  match t.from with
  | Some before when Context.in_library c t.at -> in_program c before
  | Some _ | None -> t.at

let restart c ~name (t : t) : Restart_fact.t =
  let at = in_program c t in
  match (t.waiting, t.task) with
  | Some waiting, task -> Before_the_end { at; waiting; task }
  | None, task ->
      (* Places in the library do not help the user. *)
      let is_own hop = not (Context.in_library c hop.at || String.equal hop.name "") in
      Growing
        {
          at;
          name = Option.value task ~default:name;
          is_task = Option.is_some task;
          added = t.added;
          is_choice = String.equal t.added an_if;
          way = List.map (fun hop -> (hop.name, hop.at)) (List.filter is_own (since t));
        }

let report c ~name t = Context.stop c (Restart (restart c ~name t))
