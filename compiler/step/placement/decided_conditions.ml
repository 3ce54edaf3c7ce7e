open Ir
open Basis
module Known = Map.Make (Int)

(* A known fact about a variable. *)
type fact = Truth of bool | Constructor of int | Not_constructors of int list

type context = {
  sums : Flow.Ir.sum array;
  definitions : expr Int_table.t;  (** definitions of Bool variables *)
}

let truth known (v : variable) =
  match Known.find_opt v.id known with
  | Some (Truth b) -> Some b
  | Some (Constructor _ | Not_constructors _) | None -> None

let has_constructor c known (v : variable) ~sum ~constructor =
  match Known.find_opt v.id known with
  | Some (Constructor k) -> Some (k = constructor)
  | Some (Not_constructors ks) when List.mem constructor ks -> Some false
  | Some (Not_constructors ks) ->
      let all = List.length c.sums.(sum).constructors in
      if List.length ks = all - 1 then Some true else None
  | Some (Truth _) | None -> None

(* Maximum length of a chain of variable definitions that [learn] follows. *)
let depth = 4

(* Adds the facts that follow if the condition has this truth value. *)
let rec learn ?(depth = depth) c known holds = function
  | Variable v when Option.is_none (truth known v) -> (
      let known = Known.add v.id (Truth holds) known in
      match Int_table.find_opt c.definitions v.id with
      | Some definition when depth > 0 -> learn ~depth:(depth - 1) c known holds definition
      | Some _ | None -> known)
  | Operation { operator = Not; arguments = [ e ]; _ } -> learn ~depth c known (not holds) e
  | Operation { operator = And; arguments; _ } when holds -> learn_all ~depth c known true arguments
  | Operation { operator = Or; arguments; _ } when not holds ->
      learn_all ~depth c known false arguments
  | Is_constructor { value = Variable v; constructor; _ } -> (
      match Known.find_opt v.id known with
      | _ when holds -> Known.add v.id (Constructor constructor) known
      | Some (Not_constructors ks) when not (List.mem constructor ks) ->
          Known.add v.id (Not_constructors (constructor :: ks)) known
      | None -> Known.add v.id (Not_constructors [ constructor ]) known
      | Some _ -> known)
  | _ -> known

and learn_all ~depth c known holds arguments =
  List.fold_left (fun known e -> learn ~depth c known holds e) known arguments

let rec expr c known = function
  | Variable v as e -> ( match truth known v with Some b -> Bool b | None -> e)
  | Is_constructor { sum; value = Variable v; constructor } as e -> (
      match has_constructor c known v ~sum ~constructor with Some b -> Bool b | None -> e)
  | Operation { operator = Not; ty; arguments = [ e ]; span } -> (
      match expr c known e with
      | Bool b -> Bool (not b)
      | e -> Operation { operator = Not; ty; arguments = [ e ]; span })
  | Operation { operator = And; ty; arguments = [ a; b ]; span } -> (
      let a = expr c known a in
      match (a, lazy (expr c (learn c known true a) b)) with
      | Bool false, _ -> Bool false
      | Bool true, (lazy b) -> b
      | a, (lazy (Bool true)) -> a
      | _, (lazy (Bool false)) -> Bool false
      | a, (lazy b) -> Operation { operator = And; ty; arguments = [ a; b ]; span })
  | Operation { operator = Or; ty; arguments = [ a; b ]; span } -> (
      let a = expr c known a in
      match (a, lazy (expr c (learn c known false a) b)) with
      | Bool true, _ -> Bool true
      | Bool false, (lazy b) -> b
      | a, (lazy (Bool false)) -> a
      | _, (lazy (Bool true)) -> Bool true
      | a, (lazy b) -> Operation { operator = Or; ty; arguments = [ a; b ]; span })
  | Select { condition; then_; else_; span } -> (
      match expr c known condition with
      | Bool true -> expr c known then_
      | Bool false -> expr c known else_
      | condition ->
          let then_ = expr c (learn c known true condition) then_ in
          let else_ = expr c (learn c known false condition) else_ in
          Select { condition; then_; else_; span })
  | e -> Walk.map_children (expr c known) e

let argument c known : argument -> argument = function
  | Accumulated _ as a -> a
  | Each e -> Each (expr c known e)
  | Same e -> Same (expr c known e)
  | Counted e -> Counted (expr c known e)

(* The statements of a branch that replaces its [If]. Variables that the [If] declared are now
   declared where this branch assigns them. [None] if the branch assigns some of them only inside
   other statements. *)
let in_place (uninitialized : variable list) branch =
  let is_uninitialized (v : variable) =
    List.exists (fun (u : variable) -> u.id = v.id) uninitialized
  in
  let assigned = function
    | Assign { place = Local v; _ } when is_uninitialized v -> Some v.id
    | _ -> None
  in
  let here = List.filter_map assigned branch in
  if List.length (List.sort_uniq Int.compare here) < List.length uninitialized then None
  else
    let declared = function
      | Assign { place = Local variable; value; span } when is_uninitialized variable ->
          Declare { variable; value; span }
      | statement -> statement
    in
    Some (Long_list.map declared branch)

let rec block c known body =
  List.rev (List.fold_left (fun done_ s -> List.rev_append (one c known s) done_) [] body)

and one c known statement =
  let e = expr c known in
  match statement with
  | Declare { variable; value; span } ->
      let value = e value in
      if variable.ty = Bool then Int_table.replace c.definitions variable.id value;
      [ Declare { variable; value; span } ]
  | Assign { place; value; span } -> [ Assign { place; value = e value; span } ]
  | Return { value; span } -> [ Return { value = e value; span } ]
  | Step s -> [ Step { s with arguments = Long_list.map e s.arguments } ]
  | Reset r -> [ Reset { r with arguments = Long_list.map e r.arguments } ]
  | Loop l ->
      let initial = Long_list.map e l.initial in
      [ Loop { l with initial; arguments = Long_list.map (argument c known) l.arguments } ]
  | Enter _ | Run _ -> [ statement ]
  | If i -> (
      let condition = e i.condition in
      match condition with
      | Bool true ->
          let then_ = block c known i.then_ in
          Option.value (in_place i.uninitialized then_) ~default:[ If { i with condition; then_ } ]
      | Bool false ->
          let else_ = block c known i.else_ in
          Option.value (in_place i.uninitialized else_) ~default:[ If { i with condition; else_ } ]
      | _ ->
          let branch holds body = block c (learn c known holds condition) body in
          [ If { i with condition; then_ = branch true i.then_; else_ = branch false i.else_ } ])

(* {1 Unread variables} *)

let note_reads read =
  let note = function Variable v -> Int_table.replace read v.id () | _ -> () in
  fun statement -> Walk.expressions note [ statement ]

let negated ~span = function
  | Operation { operator = Not; arguments = [ e ]; _ } -> e
  | e -> Operation { operator = Not; ty = Bool; arguments = [ e ]; span }

(* Goes from the last statement to the first, because a variable is also unread if only unread
   variables depend on it. *)
let rec without_unread read body =
  let is_read (v : variable) = Int_table.mem read v.id in
  List.fold_left
    (fun later statement ->
      match statement with
      | Declare { variable; _ } when not (is_read variable) -> later
      | Assign { place = Local v; _ } when not (is_read v) -> later
      | If i -> (
          let then_ = without_unread read i.then_ in
          let else_ = without_unread read i.else_ in
          let condition, then_, else_ =
            match then_ with
            | [] -> (negated ~span:i.span i.condition, else_, [])
            | _ -> (i.condition, then_, else_)
          in
          match then_ with
          | [] -> later
          | _ ->
              note_reads read (Return { value = condition; span = i.span });
              let uninitialized = List.filter is_read i.uninitialized in
              If { i with uninitialized; condition; then_; else_ } :: later)
      | statement ->
          note_reads read statement;
          statement :: later)
    [] (List.rev body)

let statements sums body =
  let has_branches = List.exists (function If _ -> true | _ -> false) body in
  if not has_branches then body
  else
    let c = { sums; definitions = Int_table.create 16 } in
    without_unread (Int_table.create 64) (block c Known.empty body)
