module F = Flow.Ir
open Basis
open Fragment

let possible (program : F.program) =
  let found = Array.make (Array.length program.nodes) false in
  let delayed = List.exists (fun (t : F.transition) -> t.delayed) in
  let has_components =
    List.exists (fun (i : F.import) -> i.kind = Signal_function) program.imports
  in
  let note (m : F.machine) =
    let transitions = List.map (fun mode -> program.nodes.(mode).transitions) m.modes in
    if (not (delayed m.controls)) && not (List.exists delayed transitions) then
      List.iter (fun mode -> found.(mode) <- true) m.modes
  in
  if not has_components then
    Array.iter (fun (node : F.node) -> Option.iter note node.machine) program.nodes;
  found

let operands = function Computed c -> c.operands | Action a -> a.operands
let defined = function Computed c -> [ c.signal ] | Action a -> a.defines

(* Goes from the last item to the first, because each item follows the items that it depends on. *)
let needed_for ({ leaves; items; _ } : Fragment.t) (atoms : atom list) =
  let wanted = Int_table.create 16 and fields = Int_table.create 16 in
  let want (atom : atom) =
    match atom with
    | Bool _ | Int _ | Float _ -> ()
    | Signal s -> (
        Int_table.replace wanted s.id ();
        match Int_table.find_opt leaves s.id with
        | Some (Field field) -> Int_table.replace fields field.id ()
        | Some _ | None -> ())
  in
  let is_wanted item =
    List.exists (fun (s : F.signal) -> Int_table.mem wanted s.id) (defined item)
    ||
    match item with
    | Action { advances = Some field; _ } -> Int_table.mem fields field.id
    | Action { advances = None; _ } | Computed _ -> false
  in
  List.iter want atoms;
  let needed = Array.make (Array.length items) false in
  for k = Array.length items - 1 downto 0 do
    if is_wanted items.(k) then (
      needed.(k) <- true;
      List.iter want (operands items.(k)))
  done;
  needed

let needed (fragment : Fragment.t) ending =
  let results = List.map (fun (_, atom, _) -> atom) fragment.results in
  needed_for fragment (ending.ends :: List.filteri (fun k _ -> k >= ending.told) results)

let either ~fresh (node : F.node) (items, (a : atom)) b =
  let id = fresh () in
  let signal : F.signal = { id; name = ""; ty = Bool; group = id; span = node.span } in
  let build arguments = Ir.Operation { operator = Or; ty = Bool; arguments; span = node.span } in
  let operands = [ a; b ] in
  let item = Computed { signal; operands; build; choice = None; weight = 1; span = node.span } in
  (item :: items, F.Signal signal)

let find ~fresh ~resolve (node : F.node) (fragment : Fragment.t) =
  let occurs = List.map (fun (t : F.transition) -> resolve t.occurs) node.transitions in
  let can_occur = List.filter (function F.Bool false -> false | _ -> true) occurs in
  let is_signal = function F.Signal _ -> true | Bool _ | Int _ | Float _ -> false in
  let tries = List.exists (fun (i : F.instance) -> i.trials <> []) node.instances in
  match can_occur with
  | first :: others
    when List.for_all is_signal can_occur && (not tries) && Option.is_none fragment.returned
         && Option.is_none (Late.split fragment) ->
      let more, ends = List.fold_left (either ~fresh node) ([], first) others in
      let items = Array.append fragment.items (Array.of_list (List.rev more)) in
      let told = List.length node.outputs in
      { fragment with items; ending = Some { ends; told; span = node.span } }
  | _ -> fragment
