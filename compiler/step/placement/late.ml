module Flow = Flow.Ir
open Basis
open Fragment

type user =
  | Item of int
  | State of int
  | Result of int
  | Returned

type t = {
  fragment : Fragment.t;
  definer : int Int_table.t;  (* items by signal *)
  users : user list Int_table.t;  (* by signal; of what is needed *)
  written : unit Int_table.t;  (* fields *)
  kept : (int, Ir.field) Hashtbl.t;  (* y, and the field that holds it in the end *)
  late_items : bool array;
  late_results : bool array;
  mutable late_return : bool;
}

let operands = function Computed c -> c.operands | Action a -> a.operands

let defined = function
  | Computed c -> [ c.signal ]
  | Action a -> a.defines

let users t (s : Flow.signal) = Option.value (Int_table.find_opt t.users s.id) ~default:[]

let use t user (atom : atom) =
  match atom with
  | Signal s -> Int_table.replace t.users s.id (user :: users t s)
  | Bool _ | Int _ | Float _ -> ()

let find_users t =
  let { items; results; states; returned; _ } = t.fragment in
  List.iteri (fun k (_, atom, _) -> use t (Result k) atom) results;
  List.iteri (fun k (_, atom, _, _) -> use t (State k) atom) states;
  Option.iter (fun (atom, _) -> use t Returned atom) returned;
  for k = Array.length items - 1 downto 0 do
    let always = match items.(k) with Action a -> a.always | Computed _ -> false in
    if always || List.exists (fun s -> users t s <> []) (defined items.(k)) then
      List.iter (use t (Item k)) (operands items.(k))
  done

let computed t (s : Flow.signal) =
  match Option.map (Array.get t.fragment.items) (Int_table.find_opt t.definer s.id) with
  | Some (Computed c) -> Some c
  | Some (Action _) | None -> None

let is_signal (s : Flow.signal) (atom : atom) =
  match atom with Signal other -> other.id = s.id | Bool _ | Int _ | Float _ -> false

(* Choices that keep what a field has. *)
let find_kept t =
  List.iter
    (fun (field, atom, own, _) ->
      match ((atom : atom), own) with
      | Signal y, Some before -> (
          match computed t y with
          | Some { choice = Some (_, then_, else_); _ }
            when is_signal before then_ || is_signal before else_ ->
              Hashtbl.replace t.kept y.id field
          | Some _ | None -> ())
      | (Signal _ | Bool _ | Int _ | Float _), _ -> ())
    t.fragment.states

let is_late_user t = function
  | Item k -> t.late_items.(k)
  | Result k -> t.late_results.(k)
  | Returned -> t.late_return
  | State _ -> false

let may_be_read_late t (atom : atom) =
  match atom with
  | Bool _ | Int _ | Float _ -> true
  | Signal s -> (
      Hashtbl.mem t.kept s.id
      ||
      match (Int_table.find_opt t.fragment.leaves s.id, Int_table.find_opt t.definer s.id) with
      | Some (Field field), _ -> not (Int_table.mem t.written field.id)
      | Some (Variable _ | Param _), _ -> true
      | Some _, _ -> false
      | None, Some k -> t.late_items.(k)
      | None, None -> false)

(* Nothing is late because all else is: from all that might be, what cannot is
   taken away until nothing changes. *)
let rec settle t =
  let changed = ref false in
  let no () = changed := true in
  Array.iteri
    (fun k late ->
      let item = t.fragment.items.(k) in
      if
        late
        && not
             (List.for_all (is_late_user t) (List.concat_map (users t) (defined item))
             && List.for_all (may_be_read_late t) (operands item))
      then (
        t.late_items.(k) <- false;
        no ()))
    t.late_items;
  List.iteri
    (fun k (_, atom, _) ->
      if t.late_results.(k) && not (may_be_read_late t atom) then (
        t.late_results.(k) <- false;
        no ()))
    t.fragment.results;
  Option.iter
    (fun (atom, _) ->
      if t.late_return && not (may_be_read_late t atom) then (
        t.late_return <- false;
        no ()))
    t.fragment.returned;
  let own_state = function State _ -> true | Item _ | Result _ | Returned -> false in
  Hashtbl.iter
    (fun id _ ->
      let own, others =
        List.partition own_state (Option.value (Int_table.find_opt t.users id) ~default:[])
      in
      if List.compare_length_with own 1 <> 0 || not (List.for_all (is_late_user t) others) then (
        Hashtbl.remove t.kept id;
        no ()))
    (Hashtbl.copy t.kept);
  if !changed then settle t

(* What is made of no signal that is kept may as well come first. *)
let rec reads_kept t (atom : atom) =
  match atom with
  | Bool _ | Int _ | Float _ -> false
  | Signal s -> (
      Hashtbl.mem t.kept s.id
      ||
      match Int_table.find_opt t.definer s.id with
      | Some k when t.late_items.(k) ->
          List.exists (reads_kept t) (operands t.fragment.items.(k))
      | Some _ | None -> false)

let divided t : Fragment.t * Fragment.t =
  let { leaves; items; results; returned; _ } = t.fragment in
  let part late list =
    List.filteri (fun k _ -> Bool.equal t.late_results.(k) late) list
  in
  let items_of late =
    Array.of_list
      (List.filteri (fun k _ -> Bool.equal t.late_items.(k) late) (Array.to_list items))
  in
  let leaves_later = Int_table.copy leaves in
  Hashtbl.iter (fun id field -> Int_table.replace leaves_later id (Ir.Field field)) t.kept;
  ( {
      t.fragment with
      items = items_of false;
      results = part false results;
      returned = (if t.late_return then None else returned);
    },
    {
      t.fragment with
      leaves = leaves_later;
      items = items_of true;
      results = part true results;
      states = [];
      returned = (if t.late_return then returned else None);
    } )

let split (fragment : Fragment.t) =
  let t =
    {
      fragment;
      definer = Int_table.create 64;
      users = Int_table.create 64;
      written = Int_table.create 16;
      kept = Hashtbl.create 8;
      late_items =
        Array.map (function Computed _ -> true | Action _ -> false) fragment.items;
      late_results = Array.make (List.length fragment.results) true;
      late_return = true;
    }
  in
  Array.iteri
    (fun k item ->
      List.iter (fun (s : Flow.signal) -> Int_table.replace t.definer s.id k) (defined item))
    fragment.items;
  List.iter
    (fun ((field : Ir.field), _, _, _) -> Int_table.replace t.written field.id ())
    fragment.states;
  find_kept t;
  if Hashtbl.length t.kept = 0 then None
  else (
    find_users t;
    settle t;
    let first atom = not (reads_kept t atom) in
    let settle_result k (_, atom, _) = if first atom then t.late_results.(k) <- false in
    List.iteri settle_result fragment.results;
    Option.iter (fun (atom, _) -> if first atom then t.late_return <- false) fragment.returned;
    (* What these are made of. *)
    settle t;
    if t.late_return && Option.is_some fragment.returned || Array.mem true t.late_results then
      Some (divided t)
    else None)
