module M = Step.Ir

type t = { reset : Cost.t; step : Cost.t }

type context = {
  program : M.program;
  node : M.node;
  done_ : t array;  (** costs of the preceding nodes *)
  scalars : int array;  (** number of scalars in the states of these nodes *)
}

let scalars c ty = Step.Block.scalars c.program.sums ty

let stored c (field : M.field) =
  match field.content with
  | Value ty -> Cost.several (scalars c ty) Stores
  | State_of _ | States_of _ | Running_mode | Modes _ | Component _ -> Cost.one Stores

(* The number of scalars that are read to copy the state. *)
let rec scalars_of_state c fields =
  let content (field : M.field) =
    match field.content with
    | Value ty -> scalars c ty
    | State_of k -> c.scalars.(k)
    | States_of { node; count } -> Basis.Saturating_int.times count c.scalars.(node)
    | Running_mode | Component _ -> 1
    | Modes modes ->
        let mode m = scalars_of_state c (Step.State.fields_of_mode m) in
        List.fold_left (fun most m -> max most (mode m)) 0 modes
  in
  List.fold_left (fun sum field -> Basis.Saturating_int.add sum (content field)) 0 fields

let operation (operator : Flow.Ir.operator) (ty : M.ty) =
  match operator with
  | Add | Subtract | Negate | Bitwise _ -> Cost.one Additions
  | Multiply -> Cost.one Multiplications
  | Divide | Div | Mod -> Cost.one Divisions
  | Absolute -> if ty = Float then Cost.one (Calls "fabs") else Cost.one Choices
  | Signum | Equal | Less | Less_equal | Minimum | Maximum | Not | And | Or -> Cost.one Choices
  | To_float | Round | Floor | Ceiling | Truncate -> Cost.one Conversions
  | Pow -> Cost.one (Calls "pow")
  | Elementary Floor_float -> Cost.one (Calls "floor")
  | Elementary Ceiling_float -> Cost.one (Calls "ceil")
  | Elementary Nanoseconds ->
      Cost.(sum [ one Multiplications; several 2 Choices; several 2 Additions ])
  | Elementary f -> Cost.one (Calls (Core.Primitive_table.name (Elementary f)))

(* The cost of the slowest path through the conversion; see the helper functions in the generated
   C. *)
let in_nanoseconds =
  Cost.(
    sum
      [
        one Conversions; one Divisions; one Multiplications; several 2 Choices; several 2 Additions;
      ])

(* The cost of the pixels that a kernel reads, without the call itself. *)
let looks c node arguments =
  match c.program.nodes.(node).foreign with
  | None -> Cost.none
  | Some { import = { symbol; _ }; _ } -> (
      match Kernels.find symbol with
      | None -> Cost.none
      | Some kernel -> (
          match Kernels.pixels kernel.looks arguments with
          | Some n -> Cost.several n (Pixels symbol)
          | None -> Cost.one (Images symbol)))

let rec expression c (e : M.expr) =
  match e with
  | Bool _ | Int _ | Float _ | Zero_time | Absent _ | Variable _ | Dt | Dt_nanoseconds -> Cost.none
  | Field { content = Value ty; _ } -> Cost.several (scalars c ty) Loads
  | Field _ | Param _ -> Cost.one Loads
  | Operation { operator; ty; arguments } ->
      Cost.add (operation operator ty) (expressions c arguments)
  | Select { condition; then_; else_ } ->
      let branches = Cost.larger (expression c then_) (expression c else_) in
      Cost.sum [ Cost.one Choices; expression c condition; branches ]
  | Construct { payload; _ } -> expressions c payload
  | Is_constructor { value = Field _; _ } -> Cost.add (Cost.one Choices) (Cost.one Loads)
  | Is_constructor { value; _ } -> Cost.add (Cost.one Choices) (expression c value)
  | Payload { sum; value = Field _; constructor; leaf } ->
      let leaves = Flow.Shape.payload (List.nth c.program.sums.(sum).constructors constructor) in
      Cost.several (scalars c (Step.Layout.ty (List.nth leaves leaf))) Loads
  | Payload { value; _ } -> expression c value
  | Elements { elements; _ } -> expressions c elements
  | Fill { count; value; _ } -> Cost.add (Cost.several count Choices) (expression c value)
  | Index { array = Field { content = Value (Array (_, element)); _ }; _ } ->
      Cost.several (scalars c element) Loads
  | Index { array; _ } -> expression c array
  | At { array; index; default; _ } ->
      Cost.sum [ Cost.several 3 Choices; expressions c [ array; index; default ] ]
  | Replace { array; index; value; _ } ->
      Cost.sum [ Cost.several 3 Choices; expressions c [ array; index; value ] ]
  | Call { node; arguments } ->
      Cost.sum [ c.done_.(node).step; looks c node arguments; expressions c arguments ]
  | Seconds e -> Cost.sum [ Cost.one Conversions; Cost.one Divisions; expression c e ]
  | In_nanoseconds e -> Cost.sum [ in_nanoseconds; expression c e ]
  | Soon (a, b) -> Cost.sum [ Cost.one Additions; expression c a; expression c b ]
  | Later (a, b) ->
      Cost.sum [ Cost.several 2 Additions; Cost.one Choices; expression c a; expression c b ]
  | Reached { time; period } ->
      Cost.sum [ Cost.one Conversions; Cost.several 2 Choices; expressions c [ time; period ] ]
  | Rest { time; period } ->
      Cost.sum
        (List.map Cost.one [ Conversions; Divisions; Choices ] @ [ expressions c [ time; period ] ])

and expressions c es = List.fold_left (fun cost e -> Cost.add cost (expression c e)) Cost.none es

let entry c (e : M.entry) =
  let mode = List.nth c.node.modes e.mode in
  let number = match c.node.modes with [] | [ _ ] -> Cost.none | _ :: _ :: _ -> Cost.one Stores in
  let parameters = List.map (fun (_, field) -> stored c field) mode.parameters in
  let first =
    match mode.state with
    | None -> Cost.none
    | Some _ -> Cost.add (expressions c e.arguments) c.done_.(mode.node).reset
  in
  Cost.sum ((number :: parameters) @ [ expressions c e.parameters; first ])

(* The cost of a machine's own clock. The clock advances as soon as the machine has started, and the
   step reads and stores it while the machine is active. *)
let clock c (clock : M.clock) =
  let goes_on = Cost.(sum [ one Choices; one Loads; one Stores; expression c clock.elapsed ]) in
  let seconds =
    if c.node.seconds then Cost.(add (one Conversions) (one Divisions)) else Cost.none
  in
  Cost.(sum [ goes_on; one Loads; several 2 Stores; seconds ])

let largest = List.fold_left Cost.larger Cost.none

(* The cost of the most expensive entry, together with everything that follows it. *)
let entries c followed entries =
  largest (List.map (fun (e : M.entry) -> Cost.add (entry c e) (followed e)) entries)

let run c (r : M.run) =
  let modes = Array.of_list c.node.modes and cases = Array.of_list r.cases in
  let test condition =
    if condition = M.Bool true then Cost.none
    else Cost.add (Cost.one Choices) (expression c condition)
  in
  let chosen =
    if Array.length modes > 1 then Cost.add (Cost.one Loads) (Cost.one Choices) else Cost.none
  in
  let kept = if r.drops then Cost.one Choices else Cost.none in
  let again =
    (* The cost of deciding whether another mode must run, and of counting the steps. *)
    if r.steps > 1 then Cost.add (Cost.one Choices) (Cost.one Additions) else Cost.none
  in
  let late = if r.late then Cost.several 2 Choices else Cost.none in
  let own_step k = c.done_.(modes.(k).node).step in
  (* The cost of a mode's step and of testing all its transitions. *)
  let round k (case : M.case) =
    let tests = List.map (fun (n : M.next) -> test n.condition) case.transitions in
    Cost.sum ([ chosen; expressions c case.arguments; own_step k ] @ tests @ [ kept; again; late ])
  in
  let rounds = Array.mapi round cases in
  (* The cost of a mode's step and of everything that its transitions lead to. *)
  let from followed takes k =
    let taken = List.filter takes cases.(k).transitions in
    Cost.add rounds.(k) (entries c followed (List.map (fun (n : M.next) -> n.entry) taken))
  in
  let at_entry (n : M.next) = n.at_entry = Possible in
  (* For each mode, the maximum cost of the instant in which it is entered, if at most [steps] more
     modes run in that instant. *)
  let rec entered steps =
    if steps <= 0 then Array.map (fun _ -> Cost.none) rounds
    else
      let after = entered (steps - 1) in
      Array.mapi (fun k _ -> from (fun (e : M.entry) -> after.(e.mode)) at_entry k) rounds
  in
  let after =
    let after = entered (r.steps - 1) in
    fun (e : M.entry) -> after.(e.mode)
  in
  let running = largest (List.init (Array.length rounds) (from after (fun (_ : M.next) -> true))) in
  let tests = List.map (fun (condition, _) -> test condition) r.controls in
  let controlled = entries c after (List.map snd r.controls) in
  let steps =
    if r.late then Cost.add running controlled
    else
      let entered = entries c (fun e -> from after at_entry e.mode) (List.map snd r.controls) in
      Cost.larger running entered
  in
  let active =
    match r.active with None -> Cost.none | Some e -> Cost.add (Cost.one Choices) (expression c e)
  in
  let own_time = Option.fold r.clock ~none:Cost.none ~some:(clock c) in
  Cost.sum ((own_time :: active :: tests) @ [ steps ])

let rec statement c (s : M.statement) =
  match s with
  | Declare { value; _ } | Return { value; _ } -> expression c value
  | Assign { place = Own field; value; _ } -> Cost.add (stored c field) (expression c value)
  | Assign { place = Local _ | Result _; value; _ } -> expression c value
  | If { condition; then_; else_; _ } ->
      let branches = Cost.larger (statements c then_) (statements c else_) in
      Cost.sum [ Cost.one Choices; expression c condition; branches ]
  | Step { node; arguments; on_trial; _ } ->
      let copy = if on_trial then Cost.several c.scalars.(node) Loads else Cost.none in
      Cost.sum [ copy; expressions c arguments; c.done_.(node).step; looks c node arguments ]
  | Loop l ->
      let argument : M.argument -> Cost.t = function
        | Accumulated _ -> Cost.none
        | Each e | Same e | Counted e -> expression c e
      in
      let round = Cost.sum [ Cost.one Choices; Cost.one Additions; c.done_.(l.node).step ] in
      let rounds = Cost.times l.count round in
      Cost.sum (expressions c l.initial :: rounds :: List.map argument l.arguments)
  | Reset { node; arguments; state; _ } ->
      let count = match state.content with States_of { count; _ } -> count | _ -> 1 in
      Cost.add (expressions c arguments) (Cost.times count c.done_.(node).reset)
  | Enter { entry = e; _ } -> entry c e
  | Run r -> run c r

and statements c body = List.fold_left (fun cost s -> Cost.add cost (statement c s)) Cost.none body

(* The cost of rounding dt to whole nanoseconds. In single precision, the step only clamps the
   integer that the caller has computed. *)
let whole_nanoseconds (program : M.program) =
  match program.real with
  | Double -> Cost.(sum [ one Multiplications; several 4 Choices; several 2 Additions ])
  | Single -> Cost.several 2 Choices

(* The root converts dt and replaces it with 0 in the first instant; see the helper functions in the
   generated C. *)
let root_clock (program : M.program) (root : M.node) =
  let whole = whole_nanoseconds program in
  let to_integer = match program.real with Double -> [ Cost.one Conversions ] | Single -> [] in
  let times =
    (if root.nanoseconds || root.seconds then whole :: to_integer else [])
    @ (if root.seconds then Cost.[ one Conversions; one Divisions ] else [])
    @
    (* See [frob_whole_dt]. *)
    if program.real = Double && root.seconds && not root.nanoseconds then
      Cost.[ one Multiplications; several 2 Additions; several 2 Choices ]
    else []
  in
  let first =
    match program.started with
    | None -> []
    | Some { own; _ } ->
        (if own then [ Cost.one Stores ] else [])
        @ if times = [] then [] else Cost.[ one Loads; one Choices ]
  in
  Cost.sum (first @ times)

(* The user's C functions take and return doubles. *)
let crossing (program : M.program) (node : M.node) =
  match program.real with
  | Double -> Cost.none
  | Single ->
      let given = List.map (fun (v : M.variable) -> v.ty) node.step.parameters in
      let time : M.ty list = if node.seconds then [ Float ] else [] in
      let numbers ty = Cost.several (Step.Block.numbers program.sums ty) Conversions in
      Cost.sum (List.map numbers (time @ given @ List.map snd node.outputs))

let of_program (program : M.program) =
  let nothing = { reset = Cost.none; step = Cost.none } in
  let count = Array.length program.nodes in
  let done_ = Array.make count nothing and scalars = Array.make count 0 in
  Array.iteri
    (fun k (node : M.node) ->
      let c = { program; node; done_; scalars } in
      scalars.(k) <- scalars_of_state c node.state;
      match node.foreign with
      | Some { import = { symbol; _ }; _ } ->
          let stateful = node.state <> [] in
          let call what = Cost.one (Calls (if stateful then symbol ^ what else symbol)) in
          let step = Cost.add (crossing program node) (call "_step") in
          done_.(k) <- { reset = call "_reset"; step }
      | None ->
          done_.(k) <- { reset = statements c node.reset.body; step = statements c node.step.body })
    program.nodes;
  let last = count - 1 in
  let root = done_.(last) in
  { reset = root.reset; step = Cost.add (root_clock program program.nodes.(last)) root.step }
