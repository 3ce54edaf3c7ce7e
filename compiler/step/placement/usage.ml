open Basis
module Flow = Flow.Ir
open Fragment

(* For a signal, the innermost branch that contains all its uses visited so far. *)
type guard =
  | Nowhere
  | Under of int * bool  (** the condition's signal, and its value in this branch *)
  | Anywhere

type t = {
  fragment : Fragment.t;
  item_of : int Int_table.t;
  uses : int Int_table.t;
  apart : unit Int_table.t;
  taken : unit Int_table.t;  (** choices that have been translated to branches of a write *)
  branching : unit Int_table.t;  (** conditions that get an [If] *)
  predicted : unit Int_table.t;  (** conditions of the choices in {!Feedback} *)
  mutable writes : write list;
  mutable results : write list;
}

let expression_size = 16

(* Approximate cost of a mispredicted branch, in additions. *)
let branch_weight = 12
let branch_count = 4

(* Maximum nesting of choices in one write. *)
let update_depth = 8
let get table key ~default = Option.value (Int_table.find_opt table key) ~default

let ty t (s : Flow.signal) : Ir.ty =
  if Int_table.mem t.fragment.nanoseconds s.id then Nanoseconds else Layout.ty s.ty

let leaf t (s : Flow.signal) = Int_table.find_opt t.fragment.leaves s.id
let uses t (s : Flow.signal) = get t.uses s.id ~default:0

let item_of t (s : Flow.signal) =
  Option.map (fun k -> (k, t.fragment.items.(k))) (Int_table.find_opt t.item_of s.id)

let item_uses t k =
  match t.fragment.items.(k) with
  | Computed c -> uses t c.signal
  | Action a -> List.fold_left (fun n s -> n + uses t s) 0 a.defines

let computed_of t s =
  match item_of t s with Some (_, Computed c) -> Some c | Some (_, Action _) | None -> None

let predicted t = function
  | Flow.Signal s -> Int_table.mem t.predicted s.id
  | Bool _ | Int _ | Float _ -> false

let absorbed t (s : Flow.signal) = Int_table.mem t.taken s.id
let keep_apart t (s : Flow.signal) = Int_table.replace t.apart s.id ()

let branches t (c : computed) =
  match c.choice with
  | Some (Signal condition, _, _) when Int_table.mem t.branching condition.id -> c.choice
  | Some _ | None -> None

(* Whether the signal is an array. Arrays always get a separate variable. *)
let is_array (s : Flow.signal) =
  match s.ty with Array _ -> true | Bool | Int | Float | Sum _ | Foreign _ -> false

let inlined t (s : Flow.signal) =
  match computed_of t s with
  | Some c
    when String.equal s.name ""
         && uses t s = 1
         && (not (is_array s))
         && (not (Int_table.mem t.apart s.id))
         && Option.is_none (branches t c) ->
      Some c
  | Some _ | None -> None

(* Counts uses. Goes from the last item to the first: before an item is visited, it must be known
   whether its users are needed. *)

let count t atom =
  match atom with
  | Flow.Signal s -> Int_table.replace t.uses s.id (uses t s + 1)
  | Bool _ | Int _ | Float _ -> ()

let rec update_atoms = function
  | Keep -> []
  | Set atom -> [ atom ]
  | Branch { condition; then_; else_ } ->
      condition :: List.append (update_atoms then_) (update_atoms else_)

let needed t k =
  item_uses t k > 0 || match t.fragment.items.(k) with Action a -> a.always | Computed _ -> false

let is_absorbed_item t k =
  match t.fragment.items.(k) with Computed c -> absorbed t c.signal | Action _ -> false

let backwards t visit =
  for k = Array.length t.fragment.items - 1 downto 0 do
    if needed t k && not (is_absorbed_item t k) then visit t.fragment.items.(k)
  done

let operands = function Computed c -> c.operands | Action a -> a.operands

let count_all t =
  Int_table.reset t.uses;
  let write w = List.iter (count t) (update_atoms w.update) in
  List.iter write t.results;
  List.iter write t.writes;
  Option.iter (fun (atom, _) -> count t atom) t.fragment.returned;
  Option.iter (fun ending -> count t ending.ends) t.fragment.ending;
  backwards t (fun item -> List.iter (count t) (operands item))

(* Whether an update may leave the state unchanged. *)

let rec keeps = function
  | Keep -> true
  | Set _ -> false
  | Branch { then_; else_; _ } -> keeps then_ || keeps else_

let same (own : Flow.signal option) atom =
  match (own, atom) with
  | Some own, Flow.Signal s -> own.id = s.id
  | Some _, (Bool _ | Int _ | Float _) | None, _ -> false

let rec update t own depth (atom : atom) =
  if same own atom then Keep
  else
    match atom with
    | Bool _ | Int _ | Float _ -> Set atom
    | Signal s -> (
        match computed_of t s with
        | Some { choice = Some ((Signal _ as condition), then_, else_); _ }
          when depth > 0 && uses t s = 1 ->
            let then_ = update t own (depth - 1) then_ in
            let else_ = update t own (depth - 1) else_ in
            if keeps then_ || keeps else_ || predicted t condition then
              Branch { condition; then_; else_ }
            else Set atom
        | Some _ | None -> Set atom)

(* Marks the choices that have been converted to branches of an update and no longer occur as values
   in it. *)
let rec absorb t (atom : atom) update =
  match (atom, update) with
  | Signal s, Branch { then_; else_; _ } when uses t s = 1 -> (
      match computed_of t s with
      | Some { choice = Some (_, a, b); _ } ->
          Int_table.replace t.taken s.id ();
          absorb t a then_;
          absorb t b else_
      | Some _ | None -> ())
  | (Signal _ | Bool _ | Int _ | Float _), (Keep | Set _ | Branch _) -> ()

let state_write t (field, atom, own, span) =
  let update = update t own update_depth atom in
  absorb t atom update;
  { place = Ir.Own field; update; span }

(* Finds the conditions that get an [If]. *)

let find_predicted t feedback =
  Array.iter
    (function
      | Computed { choice = Some (Signal c, _, _); signal; _ } when Feedback.mem feedback signal ->
          Int_table.replace t.predicted c.id ();
          Int_table.replace t.branching c.id ()
      | Computed _ | Action _ -> ())
    t.fragment.items

let meet a b =
  match (a, b) with
  | Nowhere, other | other, Nowhere -> other
  | Under (c, side), Under (d, other) when c = d && Bool.equal side other -> a
  | Under _, Under _ | Anywhere, _ | _, Anywhere -> Anywhere

let find_branching t =
  let guards = Int_table.create 64 and weights = Int_table.create 16 in
  let guard (s : Flow.signal) = get guards s.id ~default:Nowhere in
  let under g = function
    | Flow.Signal s -> Int_table.replace guards s.id (meet (guard s) g)
    | Bool _ | Int _ | Float _ -> ()
  in
  let charge c weight =
    let total = get weights c ~default:0 + weight in
    Int_table.replace weights c total;
    if total >= branch_weight then Int_table.replace t.branching c ()
  in
  let rec write g = function
    | Keep -> ()
    | Set atom -> under g atom
    | Branch { condition; then_; else_ } -> (
        under g condition;
        match condition with
        | Signal c ->
            write (Under (c.id, true)) then_;
            write (Under (c.id, false)) else_
        | Bool _ | Int _ | Float _ ->
            write g then_;
            write g else_)
  in
  List.iter (fun w -> write Anywhere w.update) t.results;
  List.iter (fun w -> write Anywhere w.update) t.writes;
  Option.iter (fun (atom, _) -> under Anywhere atom) t.fragment.returned;
  Option.iter (fun ending -> under Anywhere ending.ends) t.fragment.ending;
  let charge_guard g weight =
    match g with Under (c, _) -> charge c weight | Nowhere | Anywhere -> ()
  in
  backwards t (function
    | Computed c -> (
        let g = guard c.signal in
        charge_guard g c.weight;
        match c.choice with
        | Some ((Signal condition as atom), then_, else_) ->
            charge condition.id (branch_weight / branch_count);
            under g atom;
            under (Under (condition.id, true)) then_;
            under (Under (condition.id, false)) else_
        | Some _ | None -> List.iter (under g) c.operands)
    | Action a ->
        let g =
          if a.always then Anywhere
          else List.fold_left (fun g s -> meet g (guard s)) Nowhere a.defines
        in
        charge_guard g a.weight;
        List.iter (under g) a.operands)

(* Limits the sizes of expressions. Goes from the first item to the last. *)

let bound_sizes t =
  let sizes = Int_table.create 64 in
  let size = function
    | Flow.Signal s when Option.is_some (inlined t s) -> get sizes s.id ~default:1
    | Signal _ | Bool _ | Int _ | Float _ -> 0
  in
  let rec fit operands =
    let total = List.fold_left (fun n atom -> n + size atom) 1 operands in
    if total <= expression_size then total
    else
      let largest =
        List.fold_left
          (fun best atom -> if size atom > size best then atom else best)
          (Flow.Bool true) operands
      in
      match largest with
      | Signal s ->
          keep_apart t s;
          fit operands
      | Bool _ | Int _ | Float _ -> total
  in
  Array.iter
    (function
      | Computed c when uses t c.signal > 0 -> Int_table.replace sizes c.signal.id (fit c.operands)
      | Computed _ | Action _ -> ())
    t.fragment.items

(* Converts a choice with a single use into branches of the update. *)
let rec taken_apart t depth (atom : atom) =
  match atom with
  | Bool _ | Int _ | Float _ -> Set atom
  | Signal s -> (
      match computed_of t s with
      | Some c when depth > 0 && String.equal s.name "" && uses t s = 1 -> (
          match branches t c with
          | Some (condition, then_, else_) ->
              Int_table.replace t.taken s.id ();
              let then_ = taken_apart t (depth - 1) then_ in
              Branch { condition; then_; else_ = taken_apart t (depth - 1) else_ }
          | None -> Set atom)
      | Some _ | None -> Set atom)

let result_write t (place, atom, span) = { place; update = taken_apart t update_depth atom; span }

let choice t c =
  Option.map
    (fun (condition, then_, else_) ->
      let branch = taken_apart t (update_depth - 1) in
      (condition, branch then_, branch else_))
    (branches t c)

let of_fragment feedback (fragment : Fragment.t) =
  let item_of = Int_table.create 64 in
  Array.iteri
    (fun k item ->
      let define (s : Flow.signal) = Int_table.replace item_of s.id k in
      match item with Computed c -> define c.signal | Action a -> List.iter define a.defines)
    fragment.items;
  let plain (place, atom, span) = { place; update = Set atom; span } in
  let t =
    {
      fragment;
      item_of;
      uses = Int_table.create 64;
      apart = Int_table.create 16;
      taken = Int_table.create 16;
      branching = Int_table.create 16;
      predicted = Int_table.create 16;
      writes =
        List.rev
          (List.rev_map
             (fun (field, atom, _, span) -> plain (Ir.Own field, atom, span))
             fragment.states);
      results = Basis.Long_list.map plain fragment.results;
    }
  in
  find_predicted t feedback;
  count_all t;
  let writes = List.rev_map (state_write t) fragment.states in
  t.writes <-
    List.rev
      (List.filter (fun w -> match w.update with Keep -> false | Set _ | Branch _ -> true) writes);
  count_all t;
  find_branching t;
  bound_sizes t;
  t.results <- Basis.Long_list.map (result_write t) fragment.results;
  t

let writes t = t.writes
let results t = t.results
