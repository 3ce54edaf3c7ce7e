module Flow = Flow.Ir
open Basis
open Fragment

(* Code is built from back to front: the head of a block's list was placed last and runs first.
   Positions decrease from 0, so an item with a smaller position runs earlier. *)
type block = { id : int; depth : int; mutable within : branch option; mutable code : code list }

and branch = {
  position : int;
  parent : block;
  condition : Ir.expr;
  predicted : bool;
  then_ : block;
  else_ : block;
  mutable uninitialized : Ir.variable list;
  span : Span.t;
}

and code = Statement of Ir.statement | Branch_here of branch

type use = { block : block; position : int }

type t = {
  usage : Usage.t;
  uses : use list Int_table.t;  (** uses of the signals that get variables *)
  open_branches : (int * int, branch) Hashtbl.t;
      (** branches that can be shared, by block and condition *)
  root : block;
  mutable next_position : int;
  mutable next_id : int;  (** ids for blocks and, negated, for new variables *)
}

let nesting = 20

let fresh t =
  t.next_id <- t.next_id + 1;
  t.next_id

let here t block =
  t.next_position <- t.next_position - 1;
  { block; position = t.next_position }

let put block statement = block.code <- Statement statement :: block.code

let variable t (s : Flow.signal) : Ir.variable =
  { id = s.id; name = s.name; ty = Usage.ty t.usage s }

(* Expressions *)

let record t (s : Flow.signal) use =
  let others = Option.value (Int_table.find_opt t.uses s.id) ~default:[] in
  Int_table.replace t.uses s.id (use :: others)

(* [leaf] transforms the expression of each leaf. *)
let rec tree ?(leaf = Fun.id) t use (atom : atom) : Ir.expr =
  match atom with
  | Bool b -> Bool b
  | Int i -> Int i
  | Float f -> Float f
  | Signal s -> (
      match Usage.leaf t.usage s with
      | Some e -> leaf e
      | None -> (
          match Usage.inlined t.usage s with
          | Some c -> c.build (List.map (tree ~leaf t use) c.operands)
          | None ->
              record t s use;
              Variable (variable t s)))

(* Blocks *)

let rec common a b =
  if a == b then a
  else if a.depth > b.depth then outside a b
  else if a.depth < b.depth then outside b a
  else match (a.within, b.within) with Some x, Some y -> common x.parent y.parent | _, _ -> a

and outside inner other =
  match inner.within with Some branch -> common branch.parent other | None -> inner

let block_for t uses =
  match uses with
  | [] -> t.root
  | first :: rest ->
      let block = List.fold_left (fun block use -> common block use.block) first.block rest in
      if block.depth >= nesting then t.root else block

(* The position of a use, as seen from an enclosing block. *)
let rec position_in block use =
  if use.block == block then Some use.position
  else
    match use.block.within with
    | Some { parent; position; _ } -> position_in block { block = parent; position }
    | None -> None

let block_at t depth = { id = fresh t; depth; within = None; code = [] }

let new_branch ?leaf t block condition span =
  let use = here t block in
  let branch =
    {
      position = use.position;
      parent = block;
      condition = tree ?leaf t use condition;
      predicted = Usage.predicted t.usage condition;
      then_ = block_at t (block.depth + 1);
      else_ = block_at t (block.depth + 1);
      uninitialized = [];
      span;
    }
  in
  branch.then_.within <- Some branch;
  branch.else_.within <- Some branch;
  block.code <- Branch_here branch :: block.code;
  branch

(* An existing [If] with this condition in the block, if it runs before all [uses]; otherwise a new
   one. Uses outside the block come after the whole block. *)
let shared_branch t ~uses block (condition : atom) span =
  match condition with
  | Bool _ | Int _ | Float _ -> new_branch t block condition span
  | Signal c -> (
      let before (branch : branch) =
        List.for_all
          (fun use ->
            match position_in block use with
            | Some position -> position >= branch.position
            | None -> true)
          uses
      in
      match Hashtbl.find_opt t.open_branches (block.id, c.id) with
      | Some branch when before branch -> branch
      | Some _ | None ->
          let branch = new_branch t block condition span in
          Hashtbl.replace t.open_branches (block.id, c.id) branch;
          branch)

(* [branch] returns a new or existing [If] for a condition. *)
let rec store ?leaf t ~branch block (w : write) =
  match w.update with
  | Keep -> ()
  | Set atom ->
      let value = tree ?leaf t (here t block) atom in
      put block (Assign { place = w.place; value; span = w.span })
  | Branch { condition; then_; else_ } ->
      let b = branch block condition w.span in
      store ?leaf t ~branch b.else_ { w with update = else_ };
      store ?leaf t ~branch b.then_ { w with update = then_ }

(* Values that a block computes before it writes state. [saved]: values of fields that would
   otherwise be overwritten too early. [apart]: values that depend on such fields. *)
type early = { saved : (Ir.variable * Ir.field) Int_table.t; mutable apart : Flow.signal list }

let no_early () = { saved = Int_table.create 4; apart = [] }

let save t early (e : Ir.expr) : Ir.expr =
  match e with
  | Field ({ content = Value ty; _ } as field) ->
      let variable : Ir.variable =
        match Int_table.find_opt early.saved field.id with
        | Some (variable, _) -> variable
        | None ->
            let variable : Ir.variable = { id = -fresh t; name = field.name; ty } in
            Int_table.replace early.saved field.id (variable, field);
            variable
      in
      Variable variable
  | e -> e

let set_apart t early atoms =
  let apart = function
    | Flow.Signal s when Option.is_none (Usage.leaf t.usage s) ->
        Usage.keep_apart t.usage s;
        early.apart <- s :: early.apart
    | Signal _ | Bool _ | Int _ | Float _ -> ()
  in
  List.iter apart atoms

let place_early t block early =
  List.iter (fun s -> record t s (here t block)) early.apart;
  Int_table.fold (fun id saved list -> (id, saved) :: list) early.saved []
  |> List.sort (fun (a, _) (b, _) -> compare b a)
  |> List.iter (fun (_, (variable, (field : Ir.field))) ->
         put block (Declare { variable; value = Field field; span = field.span }))

(* Places the writes to state, from the last to the first. Consecutive writes with the same
   condition share an [If]. *)
let place_writes t ~into writes =
  let early = no_early () in
  let place next (w : Write_order.write) =
    match w.write.update with
    | Branch { condition = Signal c as condition; then_; else_ } when w.timing <> Early ->
        let branch =
          match next with
          | Some (id, branch) when id = c.id -> branch
          | (Some _ | None) when w.timing = Early_condition ->
              set_apart t early [ condition ];
              new_branch ~leaf:(save t early) t into condition w.write.span
          | Some _ | None -> new_branch t into condition w.write.span
        in
        let store block update = store t ~branch:(new_branch t) block { w.write with update } in
        store branch.else_ else_;
        store branch.then_ then_;
        Some (c.id, branch)
    | Keep | Set _ | Branch _ ->
        let is_early = w.timing <> In_order in
        if is_early then set_apart t early (Usage.update_atoms w.write.update);
        let leaf = if is_early then Some (save t early) else None in
        store ?leaf t ~branch:(new_branch ?leaf t) into w.write;
        None
  in
  ignore (List.fold_left place None (List.rev writes));
  place_early t into early

let place_return t writes (value, span) =
  let early = no_early () in
  let leaf =
    if Write_order.written writes value t.usage then (
      set_apart t early [ value ];
      save t early)
    else Fun.id
  in
  put t.root (Return { value = tree ~leaf t (here t t.root) value; span });
  early

(* Items, from the last to the first. *)

let uses_of t (s : Flow.signal) = Option.value (Int_table.find_opt t.uses s.id) ~default:[]

let place_computed t (c : computed) uses =
  let block = block_for t uses in
  let variable = variable t c.signal in
  match Usage.choice t.usage c with
  | None ->
      let value = c.build (List.map (tree t (here t block)) c.operands) in
      put block (Declare { variable; value; span = c.span })
  | Some (condition, then_, else_) ->
      let branch = shared_branch t ~uses block condition c.span in
      branch.uninitialized <- variable :: branch.uninitialized;
      let assign block update =
        store t ~branch:(shared_branch t ~uses) block
          { place = Local variable; update; span = c.span }
      in
      assign branch.else_ else_;
      assign branch.then_ then_

(* [always] is the block for items that write state. *)
let place_item t ~always = function
  | Computed c -> ( match uses_of t c.signal with [] -> () | uses -> place_computed t c uses)
  | Action a ->
      let uses = List.concat_map (uses_of t) a.defines in
      if a.always || uses <> [] then
        let block = if a.always then always else block_for t uses in
        let use = here t block in
        let statements = a.statements (List.map (tree t use) a.operands) in
        List.iter (put block) (List.rev statements)

(* Converts blocks to statements. The recursion is bounded by the nesting limit. *)

let negation ~span : Ir.expr -> Ir.expr = function
  | Operation { operator = Not; arguments = [ e ]; _ } -> e
  | e -> Operation { operator = Not; ty = Bool; arguments = [ e ]; span }

let rec emit block =
  let emit_code rest = function
    | Statement s -> s :: rest
    | Branch_here { condition; then_; else_; predicted; uninitialized; span; _ } -> (
        match (emit then_, emit else_) with
        | [], [] -> rest
        | [], then_ ->
            let condition = negation ~span condition in
            Ir.If { uninitialized; condition; then_; else_ = []; predicted; span } :: rest
        | then_, else_ -> Ir.If { uninitialized; condition; then_; else_; predicted; span } :: rest)
  in
  List.rev (List.fold_left emit_code [] block.code)

let statements_of feedback (fragment : Fragment.t) =
  let usage = Usage.of_fragment feedback fragment in
  let root = { id = 0; depth = 0; within = None; code = [] } in
  let t =
    {
      usage;
      uses = Int_table.create 64;
      open_branches = Hashtbl.create 16;
      root;
      next_position = 0;
      next_id = 0;
    }
  in
  let writes = Write_order.of_usage usage in
  let early = Option.map (place_return t writes) fragment.returned in
  let store_results into results =
    List.iter (store t ~branch:(shared_branch t ~uses:[]) into) (List.rev results)
  in
  let items place_for =
    for k = Array.length fragment.items - 1 downto 0 do
      place_item t ~always:(place_for k) fragment.items.(k)
    done
  in
  (match fragment.ending with
  | None ->
      place_writes t ~into:root writes;
      Option.iter (place_early t root) early;
      store_results root (Usage.results usage);
      items (fun _ -> root)
  | Some ending ->
      let results = List.mapi (fun k write -> (k, write)) (Usage.results usage) in
      let dropped, told = List.partition (fun (k, _) -> k < ending.told) results in
      let needed = Early_end.needed fragment ending in
      let goes_on = (new_branch t root ending.ends ending.span).else_ in
      place_writes t ~into:goes_on writes;
      store_results goes_on (List.map snd dropped);
      store_results root (List.map snd told);
      items (fun k -> if needed.(k) then root else goes_on));
  emit root

let append a b = List.rev_append (List.rev a) b

let statements feedback (fragment : Fragment.t) =
  let body =
    match if Option.is_some fragment.ending then None else Late.split fragment with
    | None -> statements_of feedback fragment
    | Some (first, late) -> append (statements_of feedback first) (statements_of feedback late)
  in
  append fragment.advances body
