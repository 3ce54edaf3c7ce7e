module Saturating_int = Basis.Saturating_int
module M = Step.Ir

type t = { bytes : int; chain : int list }
type bounds = { reset : t; step : t }

type context = {
  program : M.program;
  node : M.node;
  state : State.t;
  done_ : bounds array;  (** the stack bounds of the preceding nodes *)
}

let word = 8

(* Bytes that every frame needs for the return address, the frame pointer, the alignment of the
   stack, and two saved registers. *)
let fixed = 5 * word

(* Maximum stack usage of a helper function in the generated C, including its callees. *)
let helper = 12 * word

(* The number of arguments that are guaranteed to be passed in registers. *)
let in_registers = 4

(* The stack usage of a function, as far as it has been computed. *)
type frame = {
  mutable bytes : int;
  mutable helper : int;
      (** the largest stack usage of a constructor function or helper that it calls *)
  mutable callees : t list;
}

let need frame bytes = frame.bytes <- Saturating_int.add frame.bytes bytes
let needs_helper frame bytes = frame.helper <- max frame.helper bytes

let room_as real c ty =
  Saturating_int.round_up (Step.Block.of_value real c.program.sums ty).bytes ~alignment:word

let room c = room_as c.program.real c
let variable c frame (v : M.variable) = need frame (room c v.ty)

type code = Operators  (** C operators *) | Library | Helper  (** a function in the generated C *)

let code_of (operator : Flow.Ir.operator) (ty : M.ty) =
  match operator with
  | Add | Subtract | Multiply | Negate -> if ty = Int then Helper else Operators
  | Absolute -> if ty = Int then Helper else Library
  | Signum | Minimum | Maximum | Div | Mod | Round | Floor | Ceiling | Truncate | Bitwise _
  | Elementary Nanoseconds ->
      Helper
  | Pow | Elementary _ -> Library
  | Divide | Equal | Less | Less_equal | To_float | Not | And | Or -> Operators

(* Whether an expression contains calls. If it does, it keeps intermediate values in memory. *)
let rec calls (e : M.expr) =
  match e with
  | Bool _ | Int _ | Float _ | Zero_time | Absent _ | Dt | Dt_nanoseconds | Variable _ | Field _
  | Param _ ->
      false
  | Construct _ | Call _ | In_nanoseconds _ | Later _ | Soon _ | Reached _ | Rest _ | Fill _ | At _
  | Replace _ ->
      true
  | Elements { elements; _ } -> List.exists calls elements
  | Index { array; _ } -> calls array
  | Payload { value; _ } | Is_constructor { value; _ } | Seconds value -> calls value
  | Select { condition; then_; else_ } -> List.exists calls [ condition; then_; else_ ]
  | Operation { operator; ty; arguments } -> (
      match code_of operator ty with
      | Helper | Library -> true
      | Operators -> List.exists calls arguments)

let is_sum (ty : M.ty) =
  match ty with Sum _ -> true | Bool | Int | Float | Nanoseconds | Array _ | Foreign _ -> false

(* The step or reset function of a node. *)
type callee = Step of int | Reset of int

(* Adds the stack usage of an expression to [frame]. [calling] says whether the surrounding
   expression contains calls. *)
let rec within c frame ~calling (e : M.expr) =
  let all = List.iter (within c frame ~calling) in
  let intermediate () = if calling then need frame word in
  match e with
  | Bool _ | Int _ | Float _ | Zero_time | Absent _ | Dt | Dt_nanoseconds | Variable _ | Field _
  | Param _ ->
      ()
  | Operation { operator = And | Or; arguments; _ } ->
      need frame word;
      all arguments
  | Operation { operator; ty; arguments } ->
      if code_of operator ty = Helper then needs_helper frame helper;
      intermediate ();
      all arguments
  | Select { condition; then_; else_ } ->
      (* In C, such a selection may become a call to the helper that computes the minimum of two
         numbers. *)
      (match condition with
      | Operation { operator = And; _ } -> needs_helper frame helper
      | _ -> ());
      need frame (choice c then_);
      all [ condition; then_; else_ ]
  | Construct { sum; payload; _ } ->
      let made = room c (Sum sum) in
      let given = Saturating_int.times word (List.length payload) in
      needs_helper frame (List.fold_left Saturating_int.add (2 * fixed) [ made; made; made; given ]);
      need frame made;
      arguments c frame ~calling payload
  | Is_constructor { value; _ } ->
      intermediate ();
      within c frame ~calling value
  | Payload { sum; value; _ } ->
      let whole = room c (Sum sum) in
      needs_helper frame (List.fold_left Saturating_int.add (2 * fixed) [ whole; whole; whole ]);
      need frame whole;
      within c frame ~calling value
  | Elements { elements; _ } -> all elements
  | Fill { count; element; value } ->
      let made = room c (Array (count, element)) in
      needs_helper frame (Saturating_int.add (2 * fixed) (Saturating_int.times 3 made));
      need frame made;
      all [ value ]
  | Index { array; _ } ->
      intermediate ();
      within c frame ~calling array
  | At { element; array; index; default; _ } ->
      needs_helper frame (Saturating_int.add (2 * fixed) (Saturating_int.times 3 (room c element)));
      need frame (room c element);
      all [ array; index; default ]
  | Replace { count; element; array; index; value } ->
      let made = room c (Array (count, element)) in
      needs_helper frame
        (Saturating_int.add (2 * fixed)
           (Saturating_int.add (Saturating_int.times 3 made)
              (Saturating_int.times 2 (room c element))));
      need frame (Saturating_int.add made (room c element));
      all [ array; index; value ]
  | Call { node; arguments } ->
      List.iter (fun (_, ty) -> need frame (room c ty)) c.program.nodes.(node).outputs;
      call c frame (Step node) arguments
  | Seconds e ->
      intermediate ();
      within c frame ~calling e
  | In_nanoseconds e ->
      needs_helper frame helper;
      need frame word;
      all [ e ]
  | Later (a, b) | Soon (a, b) | Reached { time = a; period = b } | Rest { time = a; period = b } ->
      needs_helper frame helper;
      need frame word;
      all [ a; b ]

(* The size of a selection's value, in bytes. *)
and choice c (e : M.expr) =
  match e with
  | Variable { ty; _ } | Field { content = Value ty; _ } -> room c ty
  | Construct { sum; _ } -> room c (Sum sum)
  | Payload { sum; _ } -> room c (Sum sum)
  | Select { then_; _ } -> choice c then_
  | Call { node; _ } ->
      let add sum (_, ty) = Saturating_int.add sum (room c ty) in
      List.fold_left add 0 c.program.nodes.(node).outputs
  | Bool _ | Int _ | Float _ | Zero_time | Absent _ | Dt | Dt_nanoseconds | Field _ | Param _
  | Operation _ | Is_constructor _ | Seconds _ | In_nanoseconds _ | Later _ | Soon _ | Reached _
  | Rest _ ->
      word
  | Elements { element; elements } -> room c (Array (List.length elements, element))
  | Fill { count; element; _ } | Replace { count; element; _ } -> room c (Array (count, element))
  | At { element; _ } -> room c element
  | Index { array; _ } -> choice c array

(* Adds the stack space for the arguments that are not passed in registers: values of sum types, and
   all arguments after the first few. *)
and arguments c frame ~calling es =
  List.iteri
    (fun i (e : M.expr) ->
      (match e with
      | Variable { ty; _ } | Field { content = Value ty; _ } ->
          if is_sum ty || i >= in_registers then need frame (room c ty)
      | _ -> if calling || i >= in_registers then need frame word);
      within c frame ~calling e)
    es

and call c frame callee es =
  let bounds = match callee with Step k -> c.done_.(k).step | Reset k -> c.done_.(k).reset in
  frame.callees <- bounds :: frame.callees;
  if c.program.params <> [] then need frame word;
  arguments c frame ~calling:(List.exists calls es) es

let expression c frame e = within c frame ~calling:(calls e) e

let entry c frame (e : M.entry) =
  let mode = List.nth c.node.modes e.mode in
  List.iter (expression c frame) e.parameters;
  if Option.is_some mode.state then call c frame (Reset mode.node) e.arguments

let run c frame (r : M.run) =
  let results =
    List.fold_left (fun sum (v : M.variable) -> Saturating_int.add sum (room c v.ty)) 0 r.results
  in
  let addresses = Saturating_int.times word (List.length r.results) in
  (* The machine's flags and counters. *)
  need frame (Saturating_int.add results (4 * word));
  Option.iter (expression c frame) r.active;
  Option.iter (fun (clock : M.clock) -> expression c frame clock.elapsed) r.clock;
  List.iter
    (fun (condition, e) ->
      expression c frame condition;
      entry c frame e)
    r.controls;
  List.iteri
    (fun k (case : M.case) ->
      let mode = List.nth c.node.modes k in
      if r.drops then need frame results;
      need frame addresses;
      List.iter (variable c frame) case.others;
      need frame (Saturating_int.times word (List.length case.others));
      call c frame (Step mode.node) case.arguments;
      List.iter
        (fun (n : M.next) ->
          expression c frame n.condition;
          entry c frame n.entry)
        case.transitions)
    r.cases

let statement c frame (s : M.statement) =
  match s with
  | Declare { variable = v; value; _ } ->
      variable c frame v;
      expression c frame value
  | Assign { value; _ } | Return { value; _ } -> expression c frame value
  | If { uninitialized; condition; _ } ->
      List.iter (variable c frame) uninitialized;
      expression c frame condition
  | Step { node; arguments; results; on_trial; _ } ->
      let { State_layout.bytes; _ } = State.definition c.state node in
      if on_trial then
        need frame (Saturating_int.add word (Saturating_int.round_up bytes ~alignment:word));
      List.iter (variable c frame) results;
      need frame (Saturating_int.times word (List.length results));
      call c frame (Step node) arguments
  | Loop l ->
      (* The index, and the next values of array accumulators. *)
      need frame word;
      List.iter (variable c frame) l.results;
      List.iter (variable c frame) l.results;
      need frame (Saturating_int.times word (List.length l.results));
      List.iter (expression c frame) l.initial;
      let argument : M.argument -> M.expr option = function
        | Accumulated _ -> None
        | Each e | Same e | Counted e -> Some e
      in
      need frame (Saturating_int.times word (List.length l.arguments));
      call c frame (Step l.node) (List.filter_map argument l.arguments)
  | Reset { node; arguments; _ } -> call c frame (Reset node) arguments
  | Enter { entry = e; _ } -> entry c frame e
  | Run r -> run c frame r

(* Whether the function reads the fields of its input record in place and copies only arrays. *)
let in_place (program : M.program) k =
  k = Array.length program.nodes - 1
  &&
  match program.input with
  | Product { product_name; _ } -> not (String.equal product_name "")
  | Leaf _ | Repeated _ -> false

let function_ c k ~results (code : M.code) =
  let frame = { bytes = fixed; helper = 0; callees = [] } in
  let given present = if present then need frame word in
  given (c.node.state <> []);
  given (c.program.params <> []);
  given c.node.seconds;
  given c.node.nanoseconds;
  let in_place = in_place c.program k in
  let is_array (v : M.variable) =
    match v.ty with
    | Array _ -> true
    | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ -> false
  in
  List.iter (fun v -> if is_array v || not in_place then variable c frame v) code.parameters;
  need frame (Saturating_int.times word results);
  Step.Walk.statements (statement c frame) code.body;
  let longer (a : t) (b : t) = if b.bytes > a.bytes then b else a in
  let deepest = List.fold_left longer { bytes = frame.helper; chain = [] } frame.callees in
  { bytes = Saturating_int.add frame.bytes deepest.bytes; chain = k :: deepest.chain }

(* The user's C functions take and return structs that contain the leaves, with all numbers as
   doubles. The stack usage of the functions themselves is known only for the library's kernels. *)
let foreign_step c ({ import; _ } : Flow.Ir.foreign) =
  let own = Option.fold (Kernels.find import.symbol) ~none:0 ~some:(fun k -> k.Kernels.stack) in
  let leaves =
    List.concat_map Flow.Shape.leaves (import.result :: import.arguments) |> List.map Step.Layout.ty
  in
  let rooms =
    List.fold_left (fun sum ty -> Saturating_int.add sum (room_as Double c ty)) 0 leaves
  in
  let calls = Saturating_int.times word (2 + List.length leaves) in
  List.fold_left Saturating_int.add (2 * fixed) [ Saturating_int.times 3 rooms; calls; own ]

(* The root receives dt and the addresses of the state, the input and the output. Its step calls
   the clock's helper functions. *)
let root (program : M.program) (node : M.node) (bounds : bounds) : bounds =
  let more (t : t) bytes = { t with bytes = Saturating_int.add t.bytes bytes } in
  let clock = if node.seconds || node.nanoseconds then helper + (2 * word) else 0 in
  (* In single precision, an outer step function, which takes dt in seconds, calls this one. *)
  let outer = match program.real with Double -> 0 | Single -> fixed + (5 * word) in
  { reset = more bounds.reset word; step = more bounds.step ((4 * word) + clock + outer) }

let of_program (program : M.program) state =
  let nothing = { bytes = 0; chain = [] } in
  let count = Array.length program.nodes in
  let done_ = Array.make count { reset = nothing; step = nothing } in
  Array.iteri
    (fun k (node : M.node) ->
      let c = { program; node; state; done_ } in
      let results = List.length node.outputs in
      done_.(k) <-
        (match node.foreign with
        | Some foreign ->
            {
              reset = { bytes = fixed; chain = [ k ] };
              step = { bytes = foreign_step c foreign; chain = [ k ] };
            }
        | None ->
            { reset = function_ c k ~results:0 node.reset; step = function_ c k ~results node.step }))
    program.nodes;
  root program program.nodes.(count - 1) done_.(count - 1)
