type values = (int, Range.t) Hashtbl.t

exception Contradiction

type t = {
  values : values;
  read : values -> Ir.atom -> Range.t;
  definitions : (int, Ir.rhs) Hashtbl.t;
  narrowed : (int, unit) Hashtbl.t;  (** signals whose ranges have been narrowed *)
  followed : (int, unit) Hashtbl.t;
      (** signals whose definitions were visited in this round. Even if several definitions read a
          signal, its own definition is visited again only after the signal's range has been
          narrowed further *)
  mutable changed : bool;
}

let read t atom = t.read t.values atom
let truth b = Range.Bools { true_ = b; false_ = not b }

let narrow t (s : Ir.signal) range =
  Hashtbl.replace t.values s.id range;
  Hashtbl.replace t.narrowed s.id ();
  Hashtbl.remove t.followed s.id;
  t.changed <- true

let follow_once t (s : Ir.signal) follow =
  match Hashtbl.find_opt t.definitions s.id with
  | Some rhs when not (Hashtbl.mem t.followed s.id) ->
      Hashtbl.replace t.followed s.id ();
      follow rhs
  | Some _ | None -> ()

let can_be t atom b = (if b then Range.may_be_true else Range.may_be_false) (read t atom)

(* Traces an atom back to the equivalent atom from which it was computed. Takes at most [steps]
   steps. Each follows a copy, a branch that is certainly taken, or a payload of a value that the
   node itself constructs. *)
let origin t atom =
  let steps = ref 1000 in
  let rec go (atom : Ir.atom) =
    decr steps;
    match atom with
    | Signal s when !steps > 0 -> (
        match Hashtbl.find_opt t.definitions s.id with
        | Some (Copy atom) -> go atom
        | Some (If { condition; then_; _ }) when not (can_be t condition false) -> go then_
        | Some (If { condition; else_; _ }) when not (can_be t condition true) -> go else_
        | Some (Payload { value; constructor; leaf }) -> (
            match made (go value) with
            | Some (k, payload) when k = constructor -> go (List.nth payload leaf)
            | Some _ | None -> atom)
        | Some _ | None -> atom)
    | _ -> atom
  and made : Ir.atom -> (int * Ir.atom list) option = function
    | Signal s -> (
        match Hashtbl.find_opt t.definitions s.id with
        | Some (Construct { constructor; payload }) -> Some (constructor, payload)
        | Some _ | None -> None)
    | Bool _ | Int _ | Float _ -> None
  in
  go atom

(* Assumes that an atom has this truth value. *)
let rec assume t (atom : Ir.atom) b =
  if not (can_be t atom b) then raise Contradiction;
  match atom with
  | Signal s ->
      if can_be t atom (not b) then narrow t s (truth b);
      follow_once t s (function
        | Payload _ -> back t atom (fun made -> assume t made b)
        | rhs -> follow t rhs b)
  | Bool _ | Int _ | Float _ -> ()

and follow t (rhs : Ir.rhs) b =
  match rhs with
  | Copy atom -> assume t atom b
  | Op (Not, [ x ]) -> assume t x (not b)
  | Op (And, [ x; y ]) -> both t x y ~all:true b
  | Op (Or, [ x; y ]) -> both t x y ~all:false b
  | Op (((Less | Less_equal | Equal) as operator), [ x; y ]) -> comparison t operator x y b
  | If { condition; then_; else_ } ->
      choice t condition
        ~then_:(can_be t then_ b, fun () -> assume t then_ b)
        ~else_:(can_be t else_ b, fun () -> assume t else_ b)
  | Is_constructor (value, k) -> restrict t value (fun (other, _) -> other = k = b)
  | Op _ | Construct _ | Payload _ | Delay _ | Elements _ | Fill _ | Index _ | At _ | Replace _
  | Param _ | Absent | Time _ | Step_time | Ticks _ | Integral _ | Derivative _ ->
      ()

and comparison t (operator : Ir.operator) x y b =
  match Range.compared operator (read t x) (read t y) b with
  | None -> raise Contradiction
  | Some (in_x, in_y) ->
      number t x in_x;
      number t y in_y

(* Assumes that a number is in this range, which is a subset of its known range. *)
and number t (atom : Ir.atom) range =
  match atom with
  | Signal s when range <> read t atom ->
      narrow t s range;
      follow_once t s (function
        | Copy made -> number_within t made range
        | Payload _ -> back t atom (fun made -> number_within t made range)
        | _ -> ())
  | Signal _ | Bool _ | Int _ | Float _ -> ()

and number_within t atom range =
  match Range.meet (read t atom) range with
  | Some both -> number t atom both
  | None -> raise Contradiction

and back t atom continue =
  let made = origin t atom in
  if made <> atom then continue made

(* Assumes the result of a conjunction ([all] is true) or disjunction ([all] is false). If the
   result equals [all], so do both operands. Otherwise, if one operand certainly equals [all], the
   other one does not. *)
and both t x y ~all b =
  if b = all then (
    assume t x b;
    assume t y b)
  else (
    if not (can_be t x b) then assume t y b;
    if not (can_be t y b) then assume t x b)

and choice t condition ~then_:(then_possible, then_) ~else_:(else_possible, else_) =
  if not then_possible then assume t condition false;
  if not else_possible then assume t condition true;
  if not (can_be t condition false) then then_ ();
  if not (can_be t condition true) then else_ ()

(* Assumes that a value of a data type has one of these constructors. *)
and restrict t (atom : Ir.atom) allowed =
  match read t atom with
  | Bools _ | Ints _ | Floats _ -> ()
  | Constructors before -> (
      let left = List.filter allowed before in
      if left = [] then raise Contradiction;
      match atom with
      | Bool _ | Int _ | Float _ -> ()
      | Signal s ->
          if List.compare_lengths left before < 0 then narrow t s (Constructors left);
          follow_once t s (function
            | Copy atom -> restrict t atom allowed
            | Payload _ -> back t atom (fun made -> restrict t made allowed)
            | If { condition; then_; else_ } ->
                choice t condition
                  ~then_:(some t then_ allowed, fun () -> restrict t then_ allowed)
                  ~else_:(some t else_ allowed, fun () -> restrict t else_ allowed)
            | _ -> ()))

and some t atom allowed =
  match read t atom with
  | Constructors found -> List.exists allowed found
  | Bools _ | Ints _ | Floats _ -> true

(* The intersection of the known range and the range computed from the definition. *)
let meet known computed =
  match Range.meet known computed with Some both -> both | None -> raise Contradiction

let forward t evaluate equations =
  List.iter
    (fun (e : Ir.equation) ->
      let computed = evaluate t.values e in
      Hashtbl.replace t.values e.defines.id
        (match Hashtbl.find_opt t.values e.defines.id with
        | Some known when Hashtbl.mem t.narrowed e.defines.id -> meet known computed
        | Some _ | None -> computed))
    equations

(* Maximum number of rounds. Each round may use the results of the previous one; few conditions need
   more. *)
let rounds = 4

let narrowed values ~read ~evaluate equations assumed =
  let definitions = Hashtbl.create 64 in
  List.iter (fun (e : Ir.equation) -> Hashtbl.replace definitions e.defines.id e.rhs) equations;
  let t =
    {
      values = Hashtbl.copy values;
      read;
      definitions;
      narrowed = Hashtbl.create 16;
      followed = Hashtbl.create 16;
      changed = false;
    }
  in
  let rec again round =
    t.changed <- false;
    Hashtbl.reset t.followed;
    List.iter (fun (atom, b) -> assume t atom b) assumed;
    if t.changed then (
      forward t evaluate equations;
      if round < rounds then again (round + 1))
  in
  match again 1 with () -> Some t.values | exception Contradiction -> None
