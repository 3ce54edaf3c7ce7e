open Basis

let bug format = Diagnostic.bug ~stage:"Step.Lint" format

type context = {
  program : Ir.program;
  index : int;
  node : Ir.node;
  state : (int, Ir.field) Hashtbl.t;
  outputs : (string * Ir.ty) array;
  declared : (int, unit) Hashtbl.t;  (** ids declared anywhere in the function so far *)
}

module Known = Map.Make (Int)

(* The state of the analysis at a point of the code: variables that can be read; variables that are
   declared but not assigned; results and fields that have been written. *)
type known = {
  readable : Ir.ty Known.t;
  pending : Ir.ty Known.t;
  results : unit Known.t;
  fields : unit Known.t;
}

let show c = Print.ty c.program

let expect c what (wanted : Ir.ty) found =
  if wanted <> found then
    bug "%s in `%s` is %s where %s is needed" what c.node.name (show c found) (show c wanted)

let constructor c sum k =
  match List.nth_opt c.program.sums.(sum).constructors k with
  | Some constructor -> constructor
  | None -> bug "sum `%s` has no constructor %d" c.program.sums.(sum).name k

let field_type c (f : Ir.field) =
  match Option.map (fun (own : Ir.field) -> own.content) (Hashtbl.find_opt c.state f.id) with
  | Some (Value ty) -> ty
  | Some (State_of _ | States_of _ | Running_mode | Modes _ | Component _) ->
      bug "field `%s` of `%s` is read but is not a value" f.name c.node.name
  | None -> bug "field `%s` is not in the state of `%s`" f.name c.node.name

(* The result type of an operation, whose arguments must all have the same type. *)
let operation c (operator : Flow.Ir.operator) (ty : Ir.ty) arguments : Ir.ty =
  let of_type ty = Flow.Operator_type.result operator (List.map (fun _ -> ty) arguments) in
  let result =
    match (ty, operator, arguments) with
    | Bool, _, _ -> of_type Bool
    | Int, _, _ -> of_type Int
    | Float, _, _ -> of_type Float
    | Nanoseconds, Less_equal, [ _; _ ] -> Some Bool
    | (Nanoseconds | Sum _ | Array _ | Foreign _), _, _ -> None
  in
  match result with
  | Some result -> Layout.ty result
  | None ->
      bug "`%s` in `%s` is applied to %d operands of type %s" (Flow.Print.operator operator)
        c.node.name (List.length arguments) (show c ty)

let variable c known (v : Ir.variable) =
  match Known.find_opt v.id known.readable with
  | Some ty ->
      expect c ("variable `" ^ v.name ^ "`") v.ty ty;
      ty
  | None -> bug "variable `%s` (%d) of `%s` is read before it has a value" v.name v.id c.node.name

let param c k =
  match List.nth_opt c.program.params k with
  | Some (p : Flow.Ir.param) -> Layout.ty p.param_ty
  | None -> bug "`%s` reads a missing parameter" c.node.name

let dt c : Ir.ty =
  if not c.node.seconds then bug "`%s` reads dt but does not declare it" c.node.name;
  Float

let dt_nanoseconds c : Ir.ty =
  if not c.node.nanoseconds then
    bug "`%s` reads dt in nanoseconds but does not declare it" c.node.name;
  Nanoseconds

let payload_leaf c sum k leaf =
  match List.nth_opt (Flow.Shape.payload (constructor c sum k)) leaf with
  | Some ty -> Layout.ty ty
  | None -> bug "a payload has no leaf %d" leaf

let rec expr c known (e : Ir.expr) : Ir.ty =
  let check what wanted e = expect c what wanted (expr c known e) in
  match e with
  | Bool _ -> Bool
  | Int _ -> Int
  | Float _ -> Float
  | Zero_time -> Nanoseconds
  | Absent ty -> Foreign ty
  | Variable v -> variable c known v
  | Field f -> field_type c f
  | Param k -> param c k
  | Dt -> dt c
  | Dt_nanoseconds -> dt_nanoseconds c
  | Operation { operator; ty; arguments } ->
      List.iter (check "an operand" ty) arguments;
      operation c operator ty arguments
  | Select { condition; then_; else_ } ->
      check "a condition" Bool condition;
      let ty = expr c known then_ in
      check "a branch" ty else_;
      ty
  | Construct { sum; constructor = k; payload } ->
      let leaves = List.map Layout.ty (Flow.Shape.payload (constructor c sum k)) in
      if List.compare_lengths leaves payload <> 0 then bug "a payload of the wrong size";
      List.iter2 (check "a payload") leaves payload;
      Sum sum
  | Is_constructor { sum; value; constructor = k } ->
      ignore (constructor c sum k);
      check "a value tested" (Sum sum) value;
      Bool
  | Payload { sum; value; constructor = k; leaf } ->
      check "a deconstructed value" (Sum sum) value;
      payload_leaf c sum k leaf
  | Elements { element; elements } ->
      List.iter (check "an element" element) elements;
      Array (List.length elements, element)
  | Fill { count; element; value } ->
      check "an element" element value;
      Array (count, element)
  | Index { array; index } -> (
      match expr c known array with
      | Array (n, element) when index >= 0 && index < n -> element
      | ty -> bug "no element %d in a value of type %s in `%s`" index (show c ty) c.node.name)
  | At { count; element; array; index; default } ->
      check "an array" (Array (count, element)) array;
      check "an index" Int index;
      check "a default" element default;
      element
  | Replace { count; element; array; index; value } ->
      check "an array" (Array (count, element)) array;
      check "an index" Int index;
      check "an element" element value;
      Array (count, element)
  | Call { node; arguments } -> (
      let callee : Ir.node = callee c node in
      if callee.state <> [] then bug "`%s` is called as if it had no state" callee.name;
      call c known callee.step.parameters arguments;
      match callee.outputs with
      | [ (_, ty) ] -> ty
      | _ -> bug "`%s` is called as if it had one output" callee.name)
  | Seconds e | In_nanoseconds e ->
      check "a time" Nanoseconds e;
      Float
  | Later (a, b) | Soon (a, b) ->
      check "a time" Nanoseconds a;
      check "a time" Nanoseconds b;
      Nanoseconds
  | Reached { time; period } ->
      check "a time" Nanoseconds time;
      check "a period" Float period;
      Bool
  | Rest { time; period } ->
      check "a time" Nanoseconds time;
      check "a period" Float period;
      Nanoseconds

and callee c k : Ir.node =
  if k < 0 || k >= c.index then bug "`%s` calls a node that does not come before it" c.node.name;
  c.program.nodes.(k)

and call c known (parameters : Ir.variable list) arguments =
  if List.compare_lengths parameters arguments <> 0 then
    bug "`%s` makes a call with the wrong number of arguments" c.node.name;
  List.iter2
    (fun (p : Ir.variable) e -> expect c "an argument" p.ty (expr c known e))
    parameters arguments

let declare c (v : Ir.variable) =
  if Hashtbl.mem c.declared v.id then bug "variable %d of `%s` is declared twice" v.id c.node.name;
  Hashtbl.replace c.declared v.id ()

let readable known (v : Ir.variable) = { known with readable = Known.add v.id v.ty known.readable }

let assign c known (place : Ir.place) ty =
  match place with
  | Local v -> (
      match Known.find_opt v.id known.pending with
      | Some wanted ->
          expect c "an assigned value" wanted ty;
          readable { known with pending = Known.remove v.id known.pending } v
      | None -> bug "variable %d of `%s` is assigned but already has a value" v.id c.node.name)
  | Own f ->
      expect c "the value of a field" (field_type c f) ty;
      { known with fields = Known.add f.id () known.fields }
  | Result k ->
      if k >= Array.length c.outputs then bug "`%s` has no result %d" c.node.name k;
      expect c "a result" (snd c.outputs.(k)) ty;
      { known with results = Known.add k () known.results }

let reset c known k arguments =
  let callee : Ir.node = callee c k in
  if callee.reset.body = [] && Option.is_none callee.foreign then
    bug "`%s` resets `%s`, which has no reset" c.node.name callee.name;
  call c known callee.reset.parameters arguments

let enter c known (e : Ir.entry) =
  let mode =
    match List.nth_opt c.node.modes e.mode with
    | Some mode -> mode
    | None -> bug "`%s` has no mode %d" c.node.name e.mode
  in
  call c known (List.map fst mode.parameters) e.parameters;
  match (mode.state, e.arguments) with
  | Some _, arguments -> reset c known mode.node arguments
  | None, [] -> ()
  | None, _ :: _ -> bug "a mode of `%s` has no state to reset" c.node.name

(* Entering a mode writes the whole state of the machine. *)
let entered c known =
  List.fold_left
    (fun known (f : Ir.field) ->
      match f.content with
      | Running_mode | Modes _ -> { known with fields = Known.add f.id () known.fields }
      | Value _ | State_of _ | States_of _ | Component _ -> known)
    known c.node.state

(* Checks that the variables have the types of the values assigned to them. *)
let results c variables types =
  if List.compare_lengths variables types <> 0 then
    bug "`%s` expects the wrong number of results" c.node.name;
  List.iter2 (fun (v : Ir.variable) ty -> expect c "a result" v.ty ty) variables types

let declare_all c known variables =
  List.iter (declare c) variables;
  List.fold_left readable known variables

let run c known (run : Ir.run) =
  let condition known e = expect c "a condition" Bool (expr c known e) in
  let case (mode : Ir.mode) (case : Ir.case) =
    let callee = callee c mode.node in
    call c known callee.step.parameters case.arguments;
    results c (List.rev_append (List.rev run.results) case.others) (List.map snd callee.outputs);
    let known = declare_all c known case.others in
    List.iter
      (fun (n : Ir.next) ->
        condition known n.condition;
        enter c known n.entry)
      case.transitions
  in
  Option.iter (condition known) run.active;
  Option.iter
    (fun (clock : Ir.clock) ->
      expect c "a time" Nanoseconds (expr c known clock.elapsed);
      expect c "a clock" Nanoseconds (field_type c clock.since);
      expect c "a clock" Bool (field_type c clock.running))
    run.clock;
  if run.steps < 1 then bug "`%s` must be allowed to run at least one mode" c.node.name;
  List.iter
    (fun (e, entry) ->
      condition known e;
      enter c known entry)
    run.controls;
  if List.compare_lengths c.node.modes run.cases <> 0 then
    bug "`%s` does not have a case for each mode" c.node.name;
  List.iter2 case c.node.modes run.cases;
  declare_all c known run.results

let both a b =
  Known.merge (fun _ x y -> match (x, y) with Some x, Some _ -> Some x | _ -> None) a b

let loop c known (l : Ir.loop) =
  let callee : Ir.node = callee c l.node in
  (match (l.state, callee.state) with
  | Some { content = States_of { node; count }; _ }, _ :: _ when node = l.node && count = l.count ->
      ()
  | None, [] -> ()
  | _, _ -> bug "a loop over `%s` has the wrong state" callee.name);
  let accumulators = List.length l.initial in
  let outputs = List.map snd callee.outputs in
  let argument (p : Ir.variable) (argument : Ir.argument) =
    let found : Ir.ty =
      match argument with
      | Accumulated k when k < accumulators -> List.nth outputs k
      | Accumulated k -> bug "`%s` has no accumulator %d" callee.name k
      | Same e -> expr c known e
      | Counted e ->
          expect c "a counter" Int (expr c known e);
          Int
      | Each e -> (
          match expr c known e with
          | Array (n, element) when n = l.count -> element
          | ty -> bug "a loop over a value of type %s in `%s`" (show c ty) c.node.name)
    in
    expect c "an argument" p.ty found
  in
  if List.compare_lengths callee.step.parameters l.arguments <> 0 then
    bug "`%s` loops with the wrong number of arguments" c.node.name;
  List.iter2 argument callee.step.parameters l.arguments;
  let given k ty : Ir.ty = if k < accumulators then ty else Array (l.count, ty) in
  results c l.results (List.mapi given outputs);
  List.iteri
    (fun k e -> expect c "an initial value" (List.nth outputs k) (expr c known e))
    l.initial;
  declare_all c known l.results

let rec statement c depth known (s : Ir.statement) =
  match s with
  | Declare { variable; value; _ } ->
      expect c "a value" variable.ty (expr c known value);
      declare c variable;
      readable known variable
  | Assign { place; value; _ } -> assign c known place (expr c known value)
  | If { uninitialized; condition; then_; else_; _ } ->
      if depth > Placement.nesting + Usage.update_depth then
        bug "`%s` is nested too deeply" c.node.name;
      expect c "a condition" Bool (expr c known condition);
      List.iter (declare c) uninitialized;
      let pending =
        List.fold_left
          (fun pending (v : Ir.variable) -> Known.add v.id v.ty pending)
          known.pending uninitialized
      in
      let before = { known with pending } in
      let a = block c (depth + 1) before then_ and b = block c (depth + 1) before else_ in
      {
        readable = both a.readable b.readable;
        pending = Known.filter (fun id _ -> Known.mem id b.pending) a.pending;
        results = both a.results b.results;
        fields = both a.fields b.fields;
      }
  | Step { node; state; arguments; results = variables; _ } ->
      let callee : Ir.node = callee c node in
      (match (state, callee.state) with
      | Some { content = State_of k; _ }, _ :: _ when k = node -> ()
      | None, [] -> ()
      | _, _ -> bug "a step of `%s` has the wrong state" callee.name);
      call c known callee.step.parameters arguments;
      results c variables (List.map snd callee.outputs);
      declare_all c known variables
  | Loop l -> loop c known l
  | Reset { node; state; arguments; _ } ->
      reset c known node arguments;
      { known with fields = Known.add state.id () known.fields }
  | Enter { entry; _ } ->
      enter c known entry;
      entered c known
  | Run r -> run c known r
  | Return { value; _ } -> (
      match c.node.outputs with
      | [ (_, ty) ] ->
          expect c "the result" ty (expr c known value);
          { known with results = Known.add 0 () known.results }
      | _ -> bug "`%s` returns a value but does not have exactly one output" c.node.name)

and block c depth known body = List.fold_left (statement c depth) known body

let code c (code : Ir.code) =
  let start =
    { readable = Known.empty; pending = Known.empty; results = Known.empty; fields = Known.empty }
  in
  List.iter (declare c) code.parameters;
  let known = block c 0 (List.fold_left readable start code.parameters) code.body in
  if not (Known.is_empty known.pending) then bug "a variable of `%s` is never assigned" c.node.name;
  known

(* Rejects fields for values whose memory C owns, because these values are valid only within an
   instant. *)
let rec lasting c (f : Ir.field) =
  match f.content with
  | Value (Foreign { copyable = false; foreign_name; _ }) ->
      bug "`%s` stores a `%s`, which is only valid within an instant" c.node.name foreign_name
  | Modes modes ->
      List.iter (fun (mode : Ir.mode) -> List.iter (lasting c) (State.fields_of_mode mode)) modes
  | Value _ | State_of _ | States_of _ | Running_mode | Component _ -> ()

let without_body (node : Ir.node) =
  match (node.step.body, node.reset.body) with
  | [], [] -> ()
  | _, _ -> bug "`%s` is foreign but has a body" node.name

let wrote_all c what known =
  List.iter
    (fun (f : Ir.field) ->
      if not (Known.mem f.id known.fields) then
        bug "`%s` does not %s its field `%s`" c.node.name what f.name)
    c.node.state

let program (program : Ir.program) =
  Array.iteri
    (fun index (node : Ir.node) ->
      if Option.is_some node.foreign then without_body node
      else
        let state = Hashtbl.create 16 in
        let know (f : Ir.field) = Hashtbl.replace state f.id f in
        List.iter know node.state;
        List.iter (fun (mode : Ir.mode) -> List.iter know (State.fields_of_mode mode)) node.modes;
        let outputs = Array.of_list node.outputs in
        let context () = { program; index; node; state; outputs; declared = Hashtbl.create 16 } in
        List.iter (lasting (context ())) node.state;
        let after_step = code (context ()) node.step in
        let given = Option.value node.ends_early ~default:0 in
        List.iteri
          (fun k _ ->
            if k >= given && not (Known.mem k after_step.results) then
              bug "`%s` does not write its result %d" node.name k)
          node.outputs;
        if node.reset.body <> [] || index = Array.length program.nodes - 1 then
          wrote_all (context ()) "reset" (code (context ()) node.reset))
    program.nodes
