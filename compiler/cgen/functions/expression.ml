open Basis
module M = Step.Ir
module V = Vocabulary

type names = {
  v : Program_names.t;
  node : int;
  scope : Name.scope;
  variables : Ir.expr Int_table.t;
  in_place : (Ir.expr list -> Ir.expr) Int_table.t;
  indices : string Int_table.t; (* names of loop indices, by nesting depth *)
  limits : M.expr Int_table.t; (* see {!Limits} *)
  limits_dt : bool; (* whether to limit dt at each use *)
  reaches : M.field list; (* see {!Step.Short_times} *)
  reached : string Int_table.t; (* names of Boolean variables, by field *)
  mutable reaches_state : bool;
}

let given = [ "self"; "in"; "out"; "dt"; "dt_ns" ]

let names ?(body = []) (v : Program_names.t) ~node =
  let given = if Option.is_some v.params then "params" :: given else given in
  {
    v;
    node;
    scope = Name.scope Identifiers ~within:v.file_scope ~taken:given;
    variables = Int_table.create 16;
    in_place = Int_table.create 4;
    indices = Int_table.create 4;
    limits = Limits.in_body body;
    limits_dt = Step.Dt_limits.seconds v.dt_limits node = Where_used;
    reaches =
      (if body = [] then [] else Step.Short_times.reached v.program.real v.program.nodes.(node));
    reached = Int_table.create 4;
    reaches_state = false;
  }

let scope n = n.scope
let vocabulary n = n.v

let index n depth =
  match Int_table.find_opt n.indices depth with
  | Some name -> name
  | None ->
      let name = Name.fresh n.scope (String.make 1 (Char.chr (Char.code 'i' + min depth 10))) in
      Int_table.replace n.indices depth name;
      name

let read_elements_as n (variable : M.variable) e = Int_table.replace n.in_place variable.id e
let read_as n (variable : M.variable) e = Int_table.replace n.variables variable.id e

let variable n (variable : M.variable) =
  match Int_table.find_opt n.variables variable.id with
  | Some (Name name) -> name
  | Some _ ->
      Diagnostic.bug ~stage:"Cgen.Expression" "a variable that is read as an expression has no name"
  | None ->
      let name = Name.fresh n.scope variable.name in
      Int_table.replace n.variables variable.id (Ir.Name name);
      name

let field n (field : M.field) =
  match Int_table.find_opt n.v.nodes.(n.node).paths field.id with
  | Some (first :: inside) ->
      n.reaches_state <- true;
      List.fold_left (fun e member -> Ir.Member (e, member)) (Arrow (Name "self", first)) inside
  | Some [] | None -> Diagnostic.bug ~stage:"Cgen.Expression" "the field is not part of the state"

let state n (kept : M.field) : Ir.expr =
  match kept.content with
  | State_of node when V.home n.v node = V.home n.v n.node ->
      n.reaches_state <- true;
      Name "self"
  | State_of _ | States_of _ | Value _ | Running_mode | Modes _ | Component _ ->
      Unary (Address, field n kept)

let reaches_state n = n.reaches_state

(* A literal that is not NaN. *)
let literal : M.expr -> float option = function
  | Float x when not (Float.is_nan x) -> Some x
  | Operation { operator = Negate; arguments = [ Float x ]; _ } when not (Float.is_nan x) ->
      Some (-.x)
  | _ -> None

(* If one argument is a literal, [limit < x ? limit : x] is correct, except if the first argument is
   the literal 0: the result must then be that zero, not a zero of the other sign. This requires
   [limit <= x], which C compilers translate to a mask. *)
let limited n general simple ~zero (a : M.expr) (b : M.expr) x y =
  match (literal a, literal b) with
  | _, Some _ -> V.call n.v simple [ x; y ]
  | Some limit, None when not (Float.equal limit 0.) -> V.call n.v simple [ y; x ]
  | Some limit, None when not (V.is_negative_zero limit) -> V.call n.v zero [ y ]
  | Some _, None | None, None -> V.call n.v general [ x; y ]

(* The operands of a minimum or maximum: a literal that is not zero, its value, and the number that
   it limits. *)
let limit (operator : Flow.Ir.operator) : M.expr -> (M.expr * float * M.expr) option = function
  | Operation { operator = other; ty = Float; arguments = [ a; b ]; _ } when other = operator -> (
      match (literal a, literal b) with
      | Some limit, None when limit <> 0. -> Some (a, limit, b)
      | None, Some limit when limit <> 0. -> Some (b, limit, a)
      | _, _ -> None)
  | _ -> None

(* The name and the arguments of the function that computes this minimum of a maximum, or maximum of
   a minimum, in one call; [None] if there is no such function. *)
let clamp n (e : M.expr) =
  match Limits.limited e with
  | Some ((Variable v as x), y) when Int_table.mem n.limits v.id ->
      Some ("frob_limit_above_zero", [ x; y ])
  | Some (x, y) when Option.is_none (literal x) -> Some ("frob_limit", [ x; y ])
  | Some _ | None -> (
      let nested outer inner =
        let inside ((_, _, x) as first) =
          Option.map (fun second -> (first, second)) (limit inner x)
        in
        Option.bind (limit outer e) inside
      in
      let call (low, least, _) (high, most, _) x =
        if least < most then Some ("frob_clamp", [ x; low; high ]) else None
      in
      match (nested Maximum Minimum, nested Minimum Maximum) with
      | Some (low, ((_, _, x) as high)), _ | None, Some (high, ((_, _, x) as low)) ->
          call low high x
      | None, None -> None)

let unlimited n (variable : M.variable) value =
  Option.value (Int_table.find_opt n.limits variable.id) ~default:value

let bad () = Diagnostic.bug ~stage:"Cgen.Expression" "unexpected operands"

(* Splits a comparison of an integer with a literal into the integer, the literal, and the
   comparison as a function of the integer's value. *)
let comparison : Ir.expr -> (Ir.expr * int32 * (int32 -> bool)) option = function
  | Binary (((Less | Less_equal | Greater | Equal | Not_equal) as operator), a, b) -> (
      let holds x y =
        let order = Int32.compare x y in
        match operator with
        | Less -> order < 0
        | Less_equal -> order <= 0
        | Greater -> order > 0
        | Equal -> order = 0
        | _ -> order <> 0
      in
      match (a, b) with
      | Integer k, e -> Some (e, k, holds k)
      | e, Integer k -> Some (e, k, fun n -> holds n k)
      | _, _ -> None)
  | _ -> None

(* Whether the result of combining two comparisons of the same number is constant, as in [n <= 1 &&
   n > 3]. Clang warns about such conditions. *)
let is_decided ~by x y =
  match (comparison x, comparison y) with
  | Some (a, k, first), Some (b, l, second) when a = b ->
      let before k = if k = Int32.min_int then k else Int32.pred k in
      let after k = if k = Int32.max_int then k else Int32.succ k in
      let around k = [ before k; k; after k ] in
      let both = List.map (fun n -> by (first n) (second n)) (around k @ around l) in
      List.for_all (Bool.equal (List.hd both)) both
  | _, _ -> false

let unary n (operator : Flow.Ir.operator) (ty : M.ty) x : Ir.expr =
  let whole name : Ir.expr = Call (name, [ x ]) and real name = V.call n.v name [ x ] in
  match (operator, ty) with
  | Negate, Float -> ( match x with Float (_, 0.) -> V.float n.v (-0.) | x -> Unary (Negate, x))
  | Negate, Int -> whole "frob_int_neg"
  | Absolute, Float -> real "fabs"
  | Absolute, Int -> whole "frob_int_abs"
  | Signum, Float -> real "frob_signum"
  | Signum, Int -> whole "frob_int_signum"
  | To_float, Int -> Cast (V.real n.v, x)
  | Round, Float -> real "frob_round"
  | Floor, Float -> real "frob_floor"
  | Ceiling, Float -> real "frob_ceiling"
  | Truncate, Float -> real "frob_truncate"
  | Not, Bool -> (
      match x with
      | Binary (Equal, a, b) -> Binary (Not_equal, a, b)
      (* Only for integers: for numbers that may be NaN, the negation would be wrong. *)
      | Binary (Less_equal, (Long _ as a), b) -> Binary (Less, b, a)
      | x -> Unary (Not, x))
  | _, _ -> bad ()

let binary n (operator : Flow.Ir.operator) (ty : M.ty) (a, x) (b, y) : Ir.expr =
  let whole name : Ir.expr = Call (name, [ x; y ]) and real name = V.call n.v name [ x; y ] in
  (* gcc 12 folds expressions like [0.0 - fabs(x)] to the wrong zero, unless the operands are
     parameters of a function. *)
  let has_zero = match (a, b) with M.Float 0., _ | _, M.Float 0. -> true | _, _ -> false in
  (* Comparisons ignore the sign of zero, so a negative zero can be written as 0. *)
  let compared e x = match literal e with Some 0. -> V.float n.v 0. | _ -> x in
  let x, y =
    match operator with Equal | Less | Less_equal -> (compared a x, compared b y) | _ -> (x, y)
  in
  match (operator, ty) with
  | Add, Float when has_zero -> real "frob_add"
  | Subtract, Float when has_zero -> real "frob_subtract"
  | Add, Float -> Binary (Plus, x, y)
  | Add, Int -> whole "frob_int_add"
  | Subtract, Float -> Binary (Minus, x, y)
  | Subtract, Int -> whole "frob_int_sub"
  | Multiply, Float -> Binary (Times, x, y)
  | Multiply, Int -> whole "frob_int_mul"
  | Divide, Float -> Binary (Over, x, y)
  | Div, Int -> whole "frob_int_div"
  | Mod, Int -> whole "frob_int_mod"
  | Bitwise Bit_and, Int -> whole "frob_int_and"
  | Bitwise Bit_or, Int -> whole "frob_int_or"
  | Bitwise Bit_xor, Int -> whole "frob_int_xor"
  | Bitwise Shift_left, Int -> whole "frob_int_shift_left"
  | Bitwise Shift_right, Int -> whole "frob_int_shift_right"
  | Pow, Float -> real "frob_pow"
  | Equal, (Bool | Int | Float) -> Binary (Equal, x, y)
  | Less, (Int | Float) -> (
      (* [x > 0] reads better than [0 < x]. *)
      match a with
      | M.Float _ | Int _ -> Binary (Greater, y, x)
      | _ -> Binary (Less, x, y))
  | Less_equal, (Int | Float | Nanoseconds) -> Binary (Less_equal, x, y)
  | Minimum, Float -> limited n "frob_min" "frob_at_most" ~zero:"frob_below_zero" a b x y
  | Maximum, Float -> limited n "frob_max" "frob_at_least" ~zero:"frob_above_zero" a b x y
  | Minimum, Int -> whole "frob_int_min"
  | Maximum, Int -> whole "frob_int_max"
  | And, Bool -> if is_decided ~by:( && ) x y then whole "frob_both" else Binary (And, x, y)
  | Or, Bool when is_decided ~by:( || ) x y -> whole "frob_either"
  | Or, Bool -> Binary (Or, x, y)
  | _, _ -> bad ()

let address : Ir.expr -> Ir.expr = function
  | Unary (Dereference, pointer) -> pointer
  | e -> Unary (Address, e)

let param n k : Ir.expr =
  match n.v.params with
  | Some params -> Arrow (Name "params", Param_struct.member params k)
  | None -> Diagnostic.bug ~stage:"Cgen.Expression" "the program has no parameters"

let is_whole_period period = period >= 1. && period < 0x1p63

(* The bound at which the time in a field stops increasing; [None] for other expressions. *)
let bound n : M.expr -> int64 option = function
  | Field { id; _ } ->
      let is_time (f : M.field) = f.id = id in
      Option.bind (List.find_opt is_time n.v.program.nodes.(n.node).state) (fun f -> f.bound)
  | _ -> None

let nanoseconds ns : Ir.expr =
  if ns <= 0x7FFFFFFFL then Integer (Int64.to_int32 ns) else Cast (Uint32, Long ns)

(* Translates an operand of the operation at this place, or the value of the statement there. *)
let rec operand n ~at (e : M.expr) =
  match e with Float x -> V.literal n.v ~at x | e -> of_step n e

and of_step n (e : M.expr) : Ir.expr =
  let list = List.map (of_step n) in
  match e with
  | Bool b -> Boolean b
  | Int i -> Integer i
  | Float x -> V.float n.v x
  | Zero_time -> Integer 0l
  | Absent ty -> V.absent n.v ty
  | Variable v -> (
      match Int_table.find_opt n.variables v.id with Some e -> e | None -> Name (variable n v))
  | Field f -> field n f
  | Param k -> param n k
  | Operation { operator = Less; arguments = [ Float 0.; Dt ]; _ } ->
      Binary (Greater, Name "dt", V.float n.v 0.)
  | Dt when n.limits_dt -> V.call n.v "frob_short_dt" [ Ir.Name "dt" ]
  | Dt -> Name "dt"
  | Dt_nanoseconds -> Name "dt_ns"
  | Operation { operator = Elementary f; arguments; span; _ } ->
      V.call n.v (V.elementary f) (List.map (operand n ~at:span) arguments)
  | Operation _ when Option.is_some (clamp n e) ->
      let name, arguments = Option.get (clamp n e) in
      V.call n.v name (list arguments)
  | Operation
      { operator = Less_equal; ty = Float; arguments = [ Float x; In_nanoseconds time ]; span = _ }
    ->
      at_least n time x
  | Operation { operator; ty; arguments = [ a ]; span } ->
      unary n operator ty (operand n ~at:span a)
  | Operation { operator; ty; arguments = [ a; b ]; span } ->
      binary n operator ty (a, operand n ~at:span a) (b, operand n ~at:span b)
  | Operation _ -> bad ()
  | Select { condition; then_ = Bool true; else_; _ } ->
      Binary (Or, of_step n condition, of_step n else_)
  | Select { condition; then_; else_ = Bool false; _ } ->
      Binary (And, of_step n condition, of_step n then_)
  | Select { condition; then_; else_; span } ->
      Conditional (of_step n condition, operand n ~at:span then_, operand n ~at:span else_)
  | Construct { sum; constructor; payload } -> Call (V.maker n.v ~sum ~constructor, list payload)
  | Is_constructor { sum; value; constructor } ->
      Binary (Equal, Member (of_step n value, "tag"), Name n.v.sums.(sum).tags.(constructor))
  | Payload { sum; value; constructor; leaf } -> payload n ~sum ~constructor ~leaf (of_step n value)
  | Elements { elements; _ } -> Aggregate [ Aggregate (list elements) ]
  | Fill { count; element; value } ->
      Call (V.array_function n.v Fill (Array (count, element)), [ of_step n value ])
  | Index { array; index } -> element n array (Ir.Integer (Int32.of_int index))
  | At { count; element; array; index; default } ->
      Call
        ( V.array_function n.v At (Array (count, element)),
          [ address (of_step n array); of_step n index; of_step n default ] )
  | Replace { count; element; array; index; value } ->
      Call
        ( V.array_function n.v Replace (Array (count, element)),
          [ address (of_step n array); of_step n index; of_step n value ] )
  | Call { node; arguments = given } ->
      let arguments = arguments n n.v.program.nodes.(node).step.parameters given in
      let params = if Step.Param_use.in_step n.v.param_use node then [ Ir.Name "params" ] else [] in
      Call (n.v.nodes.(node).step, params @ arguments)
  | In_nanoseconds e -> V.call n.v "frob_time_in_ns" [ of_step n e ]
  | Seconds e -> Binary (Over, Cast (V.real n.v, of_step n e), V.float n.v 1e9)
  | Soon (a, b) -> Call ("frob_soon", list [ a; b ])
  | Later (a, b) -> Call ("frob_later", list [ a; b ])
  | Reached { time; period = Float period } when is_whole_period period ->
      Binary (Less_equal, Long (Int64.of_float period), of_step n time)
  | Reached { time; period } -> V.call n.v "frob_reached" (list [ time; period ])
  | Rest { time; period = Float period } when is_whole_period period ->
      Binary (Remainder, of_step n time, Long (Int64.of_float period))
  | Rest { time; period } -> V.call n.v "frob_rest" (list [ time; period ])

(* Comparing integers is faster than converting them to Floats first. *)
and at_least n time x =
  let reached : M.expr -> string option = function
    | Field f when bound n time = Flow.Clock.reaches n.v.program.real x ->
        Int_table.find_opt n.reached f.id
    | _ -> None
  in
  match (reached time, Flow.Clock.reaches n.v.program.real x) with
  | Some name, _ -> Name name
  | None, Some least -> (
      match bound n time with
      | Some bound when bound = least -> Binary (Equal, of_step n time, Integer 0l)
      | Some bound -> Binary (Less_equal, of_step n time, nanoseconds (Int64.sub bound least))
      | None -> Binary (Less_equal, Long least, of_step n time))
  | None, None -> Binary (Less_equal, V.float n.v x, of_step n (In_nanoseconds time))

(* The element of an array, or of nested arrays that are read in place. *)
and element n array index =
  let rec in_place (e : M.expr) indices =
    match e with
    | Variable v -> Option.map (fun read -> read indices) (Int_table.find_opt n.in_place v.id)
    | Index { array; index } -> in_place array (Ir.Integer (Int32.of_int index) :: indices)
    | _ -> None
  in
  match in_place array [ index ] with
  | Some e -> e
  | None -> Array_type.element (of_step n array) index

(* Arrays are passed by address. *)
and arguments n parameters given =
  List.map2
    (fun (p : M.variable) e ->
      match p.ty with
      | Array _ -> address (of_step n e)
      | Bool | Int | Float | Sum _ | Nanoseconds | Foreign _ -> of_step n e)
    parameters given

and payload n ~sum ~constructor ~leaf value : Ir.expr =
  let sums = n.v.program.sums in
  match List.nth (Sum_type.payload sums (List.nth sums.(sum).constructors constructor)) leaf with
  | Scalar member -> Member (value, member)
  | Inner _ -> Call (V.projection n.v ~sum ~constructor ~leaf, [ value ])

let bounded n (time : M.field) (value : M.expr) : Ir.statement_desc option =
  let set bound : Ir.statement_desc =
    let address = Ir.Unary (Address, field n time) in
    let runs_out dt = Ir.Call ("frob_runs_out", [ address; of_step n dt ]) in
    let runs_out_while condition dt =
      let all = nanoseconds bound in
      Ir.Call ("frob_runs_out_while", [ condition; address; of_step n dt; all ])
    in
    let advanced (call : Ir.expr) : Ir.statement_desc =
      if List.exists (fun (f : M.field) -> f.id = time.id) n.reaches then (
        let name = Name.fresh n.scope "reached" in
        Int_table.replace n.reached time.id name;
        Constant { ty = Bool; name; value = call })
      else Do call
    in
    match value with
    | Soon (_, dt) | Later (_, dt) -> advanced (runs_out dt)
    | Select { condition; then_ = Soon (_, dt) | Later (_, dt); else_ = Zero_time; _ } ->
        advanced (runs_out_while (of_step n condition) dt)
    | Select { condition; then_ = Zero_time; else_ = Soon (_, dt) | Later (_, dt); _ } ->
        advanced (runs_out_while (Unary (Not, of_step n condition)) dt)
    | _ -> Assign (field n time, nanoseconds bound)
  in
  Option.map set (bound n (Field time))

let parameters n variables =
  List.map
    (fun (p : M.variable) ->
      match p.ty with
      | Array _ ->
          let name = Name.fresh n.scope p.name in
          read_as n p (Unary (Dereference, Name name));
          (Ir.Pointer_to_const (V.ty n.v p.ty), name)
      | Bool | Int | Float | Sum _ | Nanoseconds | Foreign _ -> (V.ty n.v p.ty, variable n p))
    variables
