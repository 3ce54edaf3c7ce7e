open Ir
open Basis
module Known = Map.Make (Int)

(* What is longer is a step that places share. *)
let most_operations = 12

(* Of so many statements it would be long, whatever is known of them. *)
let most_statements = 100

exception Not_simple

(* What is known at a point of the code: values of fields, and of variables that need
   none of their own. *)
type known = { fields : expr Known.t; variables : expr Known.t }

type context = {
  real : Real.t;
  callee : int -> node;
  modes : mode list;
  outputs : int;
  unstepped : expr list Int_table.t;  (** arguments of resets, by the field *)
  declared : bool Int_table.t;  (** so far; not in a branch? *)
  mutable entered : entry option;  (** of the machine, not stepped yet *)
}

(* {1 Expressions} *)

(* The same wherever it is read, from here to the end of the function. *)
let is_lasting e = match e with Variable _ -> true | e -> Literal.is e

let rec simple c known e =
  match Walk.map_children (simple c known) e with
  | Field f as e -> Option.value (Known.find_opt f.id known.fields) ~default:e
  | Variable v as e -> Option.value (Known.find_opt v.id known.variables) ~default:e
  | Dt -> Float 0.
  | Dt_nanoseconds -> Zero_time
  | Operation { operator; ty; arguments } -> Literal.operation c.real operator ty arguments
  | Select { condition = Bool b; then_; else_ } -> if b then then_ else else_
  | Is_constructor { value = Construct made; constructor; _ } ->
      Bool (made.constructor = constructor)
  | Payload { value = Construct made; constructor; leaf; _ } when made.constructor = constructor ->
      List.nth made.payload leaf
  | Seconds Zero_time | In_nanoseconds Zero_time -> Float 0.
  | Later (time, Zero_time) | Soon (time, Zero_time) -> time
  | Reached { time = Zero_time; period = Float x } when x >= 1. -> Bool false
  | Rest { time = Zero_time; period = Float x } when x >= 1. -> Zero_time
  | e -> e

let simple_entry c known (entry : entry) =
  let simple = List.map (simple c known) in
  {
    entry with
    parameters = simple entry.parameters;
    first =
      (match entry.first with
      | Reset_by arguments -> Reset_by (simple arguments)
      | Started_by arguments -> Started_by (simple arguments));
  }

let in_both =
  Known.merge (fun _ a b ->
      match (a, b) with Some a, Some b when Literal.same a b -> Some a | _, _ -> None)

(* {1 Statements} *)

let keep (f : field) value known =
  let fields =
    if is_lasting value then Known.add f.id value known.fields else Known.remove f.id known.fields
  in
  { known with fields }

let assigned_locals body =
  let found = Int_table.create 8 in
  Walk.statements
    (function Assign { place = Local v; _ } -> Int_table.replace found v.id () | _ -> ())
    body;
  found

let takes_time (node : node) = node.seconds || node.nanoseconds

let without_time c node = if takes_time (c.callee node) then raise Not_simple

(* [reset] and [step] may both compute a static value. *)
let is_new c ~always (v : variable) =
  match Int_table.find_opt c.declared v.id with
  | None ->
      Int_table.replace c.declared v.id always;
      true
  | Some true -> false
  | Some false -> raise Not_simple

let all_new c ~always variables =
  if not (List.for_all (is_new c ~always) variables) then raise Not_simple

(* [pending]: variables of an [If] of which one branch is left, which are declared
   where they get their values. [always]: not in a branch. *)
let rec statement c ~always pending known (s : statement) =
  let simple = simple c known in
  match s with
  | Declare { variable; value; span } -> declare c ~always known variable (simple value) span
  | Assign { place = Local v; value; span } when List.memq v pending ->
      declare c ~always known v (simple value) span
  | Assign { place = Own f; value; span } ->
      let value = simple value in
      (keep f value known, [ Assign { place = Own f; value; span } ])
  | Assign { place = Result k; _ } when k >= c.outputs -> (known, [])
  | Assign { place; value; span } -> (known, [ Assign { place; value = simple value; span } ])
  | Return { value; span } -> (known, [ Return { value = simple value; span } ])
  | If choice -> (
      match simple choice.condition with
      | Bool holds ->
          let branch = if holds then choice.then_ else choice.else_ in
          statements c ~always (choice.uninitialized @ pending) known branch
      | condition ->
          let locals = assigned_locals (choice.then_ @ choice.else_) in
          let is_assigned (v : variable) = Int_table.mem locals v.id in
          let uninitialized = choice.uninitialized @ List.filter is_assigned pending in
          all_new c ~always uninitialized;
          let after, then_ = statements c ~always:false [] known choice.then_ in
          let after', else_ = statements c ~always:false [] known choice.else_ in
          let fields = in_both after.fields after'.fields in
          ({ known with fields }, [ If { choice with uninitialized; condition; then_; else_ } ]))
  | Step { node; state = None; arguments; results; on_trial; span } ->
      without_time c node;
      all_new c ~always results;
      let arguments = List.map simple arguments in
      (known, [ Step { node; state = None; arguments; results; on_trial; span } ])
  | Reset { node = _; state = { content = State_of _; _ } as state; arguments; span = _ } ->
      Int_table.replace c.unstepped state.id (List.map simple arguments);
      (known, [])
  | Step { node; state = Some state; arguments; results; on_trial = false; span } when always -> (
      match Int_table.find_opt c.unstepped state.id with
      | None -> raise Not_simple
      | Some reset ->
          Int_table.remove c.unstepped state.id;
          all_new c ~always results;
          (known, first_step c ~node state ~reset (List.map simple arguments) results span))
  | Loop ({ state = None; node; _ } as l) ->
      without_time c node;
      all_new c ~always l.results;
      let argument = function
        | Accumulated k -> Accumulated k
        | Each e -> Each (simple e)
        | Same e -> Same (simple e)
        | Counted e -> Counted (simple e)
      in
      let initial = List.map simple l.initial and arguments = List.map argument l.arguments in
      (known, [ Loop { l with initial; arguments } ])
  | Enter { entry; _ } when always ->
      c.entered <- Some (simple_entry c known entry);
      (known, [])
  | Run run when always -> begin_machine c known run
  | Step _ | Loop _ | Reset _ | Enter _ | Start _ | Begin _ | Await _ | Run _ -> raise Not_simple

and declare c ~always known v value span =
  if Literal.is value then ({ known with variables = Known.add v.id value known.variables }, [])
  else if is_new c ~always v then (known, [ Declare { variable = v; value; span } ])
  else (known, [])

and first_step c ~node state ~reset arguments results span =
  let callee = c.callee node in
  match callee.start with
  | Some start ->
      let arguments = Entry.given [ (callee.reset, reset); (callee.step, arguments) ] start in
      [ Start { node; state; arguments; results; span } ]
  | None ->
      without_time c node;
      [
        Reset { node; state; arguments = reset; span };
        Step { node; state = Some state; arguments; results; on_trial = false; span };
      ]

and begin_machine c known run =
  let never (condition, _) = simple c known condition = Bool false in
  match (run, c.entered) with
  | { active = None; clock = None; start = None; _ }, Some entry
    when Direct.is_direct run && List.for_all never run.controls ->
      c.entered <- None;
      let case (case : case) = { case with arguments = List.map (simple c known) case.arguments } in
      let cases = List.mapi (fun k old -> if k = entry.mode then case old else old) run.cases in
      let run = { run with cases } in
      (known, [ Begin { run; entry = Entry.started ~callee:c.callee c.modes run entry; span = run.span } ])
  | _ -> raise Not_simple

and statements c ~always pending known body =
  let add (known, made) s =
    let known, more = statement c ~always pending known s in
    (known, List.rev_append more made)
  in
  let known, made = List.fold_left add (known, []) body in
  (known, List.rev made)

(* {1 What is left over} *)

(* Values of fields that are written again before anybody reads them. *)
let without_overwritten body =
  let reads s =
    let found = Int_table.create 8 in
    Walk.expressions (function Field f -> Int_table.replace found f.id () | _ -> ()) [ s ];
    found
  in
  let step (rewritten, kept) s =
    match s with
    | Assign { place = Own f; _ } when List.mem f.id rewritten -> (rewritten, kept)
    | s ->
        let read = reads s in
        let rewritten = List.filter (fun id -> not (Int_table.mem read id)) rewritten in
        let more =
          match s with
          | Assign { place = Own f; _ } when not (Int_table.mem read f.id) -> [ f.id ]
          | _ -> []
        in
        (more @ rewritten, s :: kept)
  in
  snd (List.fold_left step ([], []) (List.rev body))

let rec without_unread body =
  let read = Int_table.create 16 in
  Walk.expressions (function Variable v -> Int_table.replace read v.id () | _ -> ()) body;
  let is_read (v : variable) = Int_table.mem read v.id in
  let changed = ref false in
  let drop () =
    changed := true;
    None
  in
  let rec clean s =
    match s with
    | (Declare { variable = v; _ } | Assign { place = Local v; _ }) when not (is_read v) -> drop ()
    | If choice -> (
        let then_ = List.filter_map clean choice.then_ in
        let else_ = List.filter_map clean choice.else_ in
        let uninitialized = List.filter is_read choice.uninitialized in
        match (then_, else_) with
        | [], [] -> drop ()
        | [], else_ ->
            let condition = Operation { operator = Not; ty = Bool; arguments = [ choice.condition ] } in
            Some (If { choice with uninitialized; condition; then_ = else_; else_ = [] })
        | then_, else_ -> Some (If { choice with uninitialized; then_; else_ }))
    | s -> Some s
  in
  let body = List.filter_map clean body in
  if !changed then without_unread body else body

(* A value without a name that was also for a transition now only is what is kept. *)
let without_detours body =
  let reads = Int_table.create 16 and values = Int_table.create 8 in
  let count id = Option.value (Int_table.find_opt reads id) ~default:0 in
  Walk.expressions
    (function Variable v -> Int_table.replace reads v.id (count v.id + 1) | _ -> ())
    body;
  let reads_state value =
    let found = ref false in
    Walk.expression (function Field _ -> found := true | _ -> ()) value;
    !found
  in
  (* Arrays that are written out have to be declared. *)
  let is_literal = function Elements _ -> true | _ -> false in
  let is_kept (v : variable) = function
    | Assign { value = Variable read; _ } -> read.id = v.id
    | _ -> false
  in
  let step = function
    | Declare { variable = { name = ""; _ } as v; value; _ }
      when (not (is_literal value))
           && count v.id = 1 && List.exists (is_kept v) body && not (reads_state value) ->
        Int_table.replace values v.id value;
        None
    | Assign ({ value = Variable v; _ } as assign) as s ->
        let put value = Assign { assign with value } in
        Some (Option.fold (Int_table.find_opt values v.id) ~none:s ~some:put)
    | s -> Some s
  in
  List.filter_map step body

(* {1 The whole} *)

let weight_of weight modes body =
  let sum = ref (Reads.of_body body).operations in
  let add node = sum := !sum + weight node in
  Walk.statements
    (function
      | Start { node; _ } -> add node
      | Begin { entry = { first = Started_by _; mode; _ }; _ } -> add (List.nth modes mode : mode).node
      | _ -> ())
    body;
  !sum

let is_long (code : code) =
  let count = ref 0 in
  Walk.statements (fun _ -> incr count) code.body;
  !count > most_statements

let body_of c ~reset ~step =
  if is_long reset || is_long step then raise Not_simple;
  let nothing = { fields = Known.empty; variables = Known.empty } in
  let _, body = statements c ~always:true [] nothing (reset.body @ step.body) in
  if Int_table.length c.unstepped > 0 || Option.is_some c.entered then raise Not_simple;
  without_detours (without_unread (without_overwritten body))

(* Some may be those of both. *)
let parameters_of body ~reset ~step =
  let seen = Int_table.create 8 in
  let is_new (v : variable) =
    (not (Int_table.mem seen v.id))
    &&
    (Int_table.replace seen v.id ();
     true)
  in
  Reads.parameters (Reads.of_body body) (List.filter is_new (reset.parameters @ step.parameters))

let of_node real ~callee ~weight ~modes ~outputs ~reset ~step =
  let unstepped = Int_table.create 4 and declared = Int_table.create 16 in
  match body_of { real; callee; modes; outputs; unstepped; declared; entered = None } ~reset ~step with
  | exception Not_simple -> None
  | body ->
      let operations = weight_of weight modes body in
      if operations > most_operations then None
      else Some ({ parameters = parameters_of body ~reset ~step; body }, operations)
