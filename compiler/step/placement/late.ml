module Flow = Flow.Ir
open Basis
open Fragment

type user =
  | Item of int
  | State
  | Output of int
      (** index of a result; the index after the last result denotes the returned value *)

type t = {
  fragment : Fragment.t;
  definer : int Int_table.t; (* index of the item that defines each signal *)
  users : user list Int_table.t; (* the users of each signal that are themselves needed *)
  written : unit Int_table.t; (* fields that the step writes *)
  kept : (int, Ir.field) Hashtbl.t;
      (* signals [y] (see the interface), and the fields that contain them at the end of the step *)
  late_items : bool array;
  late_outputs : bool array;
}

let operands = function Computed c -> c.operands | Action a -> a.operands
let defined = function Computed c -> [ c.signal ] | Action a -> a.defines
let users t (s : Flow.signal) = Option.value (Int_table.find_opt t.users s.id) ~default:[]

let use t user (atom : atom) =
  match atom with
  | Signal s -> Int_table.replace t.users s.id (user :: users t s)
  | Bool _ | Int _ | Float _ -> ()

let outputs { results; returned; _ } =
  let result (_, atom, _) = atom and returned = Option.map fst returned in
  List.rev_append (List.rev_map result results) (Option.to_list returned)

let find_users t =
  let { items; states; _ } = t.fragment in
  List.iteri (fun k atom -> use t (Output k) atom) (outputs t.fragment);
  List.iter (fun (_, atom, _, _) -> use t State atom) states;
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

(* Finds choices that may leave a field unchanged. *)
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
  | Output k -> t.late_outputs.(k)
  | State -> false

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

(* Computes the largest consistent set of late items: starts with everything that might be late, and
   repeatedly removes what cannot be late, until nothing changes. *)
let rec settle t =
  let changed = ref false in
  let not_late late k =
    late.(k) <- false;
    changed := true
  in
  Array.iteri
    (fun k late ->
      let item = t.fragment.items.(k) in
      if
        late
        && not
             (List.for_all (is_late_user t) (List.concat_map (users t) (defined item))
             && List.for_all (may_be_read_late t) (operands item))
      then not_late t.late_items k)
    t.late_items;
  List.iteri
    (fun k atom ->
      if t.late_outputs.(k) && not (may_be_read_late t atom) then not_late t.late_outputs k)
    (outputs t.fragment);
  Hashtbl.iter
    (fun id _ ->
      let users = Option.value (Int_table.find_opt t.users id) ~default:[] in
      let own, others = List.partition (fun user -> user = State) users in
      if
        List.compare_length_with own 1 <> 0
        || others = []
        || not (List.for_all (is_late_user t) others)
      then (
        Hashtbl.remove t.kept id;
        changed := true))
    (Hashtbl.copy t.kept);
  if !changed then settle t

(* The late part of the fragment if [late], otherwise the rest of it. *)
let part t late : Fragment.t =
  let { items; results; returned; _ } = t.fragment in
  let is_part flags k _ = Bool.equal flags.(k) late in
  let is_returned_here =
    Option.is_some returned && is_part t.late_outputs (List.length results) ()
  in
  {
    t.fragment with
    items = Array.of_list (List.filteri (is_part t.late_items) (Array.to_list items));
    results = List.filteri (is_part t.late_outputs) results;
    returned = (if is_returned_here then returned else None);
  }

let divided t =
  let leaves = Int_table.copy t.fragment.leaves in
  Hashtbl.iter (fun id field -> Int_table.replace leaves id (Ir.Field field)) t.kept;
  (part t false, { (part t true) with leaves; states = [] })

let split (fragment : Fragment.t) =
  let t =
    {
      fragment;
      definer = Int_table.create 64;
      users = Int_table.create 64;
      written = Int_table.create 16;
      kept = Hashtbl.create 8;
      late_items = Array.map (function Computed _ -> true | Action _ -> false) fragment.items;
      late_outputs = Array.make (List.length (outputs fragment)) true;
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
    if Hashtbl.length t.kept = 0 then None else Some (divided t))
