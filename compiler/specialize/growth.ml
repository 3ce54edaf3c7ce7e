open Basis

type t = {
  head : int list;  (* the code it starts with *)
  depth : int;
  added : string;  (* the function around the deepest nest in it *)
  name : string;
  at : Span.t;
  from : t option;
  steps : int;  (* how often in a row it has grown *)
}

let deepest nests =
  List.fold_left (fun (n, name) (m, other) -> if m > n then (m, other) else (n, name)) (0, "") nests

(* How deeply functions are nested in functions, and the outermost one of them. [known]:
   by closure, as closures are shared. *)
let rec nest known (value : Value.t) =
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
  | Product values | Elements values | Constructed { arguments = values; _ } ->
      deepest (List.map (nest known) values)
  | Choice { then_; else_; _ } -> deepest [ nest known then_; nest known else_ ]
  | Program value -> nest known value
  | Atom _ | Text _ | Array _ | Unspecified -> (0, "")

and inside known (closure : Value.closure) =
  Variables.fold
    (fun _ (entry : Value.entry) deeper ->
      match entry.contents with
      | Polymorphic _ -> deeper
      | Known _ | Suspended _ | Being_evaluated ->
          deepest [ deeper; nest known (Closure.forced entry) ])
    closure.captured (0, "")

(* Likewise of what a mode runs, but without the mode's own code. *)
let rec nest_of_mode known (value : Value.t) =
  match value with
  | Function closure | Signal_function closure -> inside known closure
  | Primitive { arguments; _ } ->
      deepest (List.map (fun (a : Value.argument) -> nest_of_mode known a.value) arguments)
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Choice _ | Program _ | Unspecified -> (0, "")

let name_of : Value.t -> string = function
  | Function closure | Signal_function closure -> closure.name
  | Primitive { owner; _ } -> owner
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Choice _ | Program _ | Unspecified -> ""

let rec head (value : Value.t) =
  match value with
  | Function closure | Signal_function closure -> [ Closure.code_id closure.code ]
  | Primitive { arguments; _ } ->
      List.concat_map (fun (a : Value.argument) -> head a.value) arguments
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Choice _ | Program _ | Unspecified -> []

(* As far back as a circle of modes is long. *)
let rec before head t steps =
  match t with
  | None -> None
  | Some t when t.head = head -> Some t
  | Some t -> if steps = 0 then None else before head t.from (steps - 1)

let of_value value ~at ~from =
  let head = head value in
  let depth, added = nest_of_mode (Variables.Table.create 16) value in
  let steps =
    match before head from 50 with
    | Some earlier when depth > earlier.depth -> earlier.steps + 1
    | Some _ | None -> 0
  in
  { head; depth; added; name = name_of value; at; from; steps }

let is_endless t = t.steps > 20

(* The modes since the last one of the same code, the first of them first. *)
let since t =
  let rec go found = function
    | Some earlier when earlier.head <> t.head -> go (earlier :: found) earlier.from
    | Some _ | None -> found
  in
  go [] t.from

let report (c : Context.t) ~name t =
  let on_the_way diagnostic hop =
    if Span.compare hop.at t.at = 0 || String.equal hop.name "" then diagnostic
    else Diagnostic.label ~at:hop.at (Printf.sprintf "on the way `%s` starts here" hop.name) diagnostic
  in
  Diagnostic.(
    error ~code:"E0416" ~at:t.at "`%s` grows each time it starts itself again" name
    |> here (Printf.sprintf "here, with one more `%s`" t.added)
    |> (fun diagnostic -> List.fold_left on_the_way diagnostic (since t))
    |> note "which signal functions can run must be known, and be finitely many"
    |> hint "start it with the same signal functions each time; numbers may change"
    |> emit c.sink);
  raise Context.Stopped
