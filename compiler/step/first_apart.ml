open Basis
open Ir

(* What is known where an expression stands. *)
type known = {
  real : Real.t;
  first : bool;  (** then no time has passed *)
  fields : (int, expr) Hashtbl.t;
  variables : (int, expr) Hashtbl.t;
}

(* The first instant, or another one, cannot be simplified to what is wanted. *)
exception Not_short

(* The value with all that is known put in. *)
let rec value known e =
  let again = value known in
  match e with
  | Bool _ | Int _ | Float _ | Zero_time | Time _ | Absent _ -> e
  | Variable v -> Option.value (Hashtbl.find_opt known.variables v.id) ~default:e
  | Field f -> Option.value (Hashtbl.find_opt known.fields f.id) ~default:e
  | Dt -> if known.first then Float 0. else e
  | Dt_nanoseconds -> if known.first then Zero_time else e
  | Operation { operator; ty; arguments } ->
      Literal.operation known.real operator ty (List.map again arguments)
  | Select { condition; then_; else_ } -> (
      match (again condition, again then_, again else_) with
      | Bool true, e, _ | Bool false, _, e -> e
      | _, a, b when Literal.is a && Literal.same a b -> a
      | condition, then_, else_ -> Select { condition; then_; else_ })
  | Seconds e -> ( match again e with Zero_time -> Float 0. | e -> Seconds e)
  | In_nanoseconds e -> ( match again e with Zero_time -> Float 0. | e -> In_nanoseconds e)
  | Later (a, b) -> (
      match (again a, again b) with Zero_time, e | e, Zero_time -> e | a, b -> Later (a, b))
  | Soon (a, b) -> (
      match (again a, again b) with Zero_time, e | e, Zero_time -> e | a, b -> Soon (a, b))
  | Reached { time; period } -> (
      match (again time, again period) with
      | Zero_time, Float period -> Bool (period < 1.)
      | time, period -> Reached { time; period })
  | Rest { time; period } -> (
      match again time with
      | Zero_time -> Zero_time
      | time -> Rest { time; period = again period })
  | Construct _ | Is_constructor _ | Payload _ | Elements _ | Fill _ | Index _ | At _ | Replace _
  | Call _ ->
      raise Not_short

(* The later instants: only that they are not the first is new. *)
let rec later known (s : statement) =
  match s with
  | Declare d -> (
      match value known d.value with
      | value when Literal.is value ->
          Hashtbl.replace known.variables d.variable.id value;
          []
      | value -> [ Declare { d with value } ])
  | Assign { place = Own field; value = Bool true; _ } when Hashtbl.mem known.fields field.id -> []
  | Assign a -> [ Assign { a with value = value known a.value } ]
  | If i -> (
      let branch = List.concat_map (later known) in
      match value known i.condition with
      | Bool _ -> raise Not_short
      | condition -> [ If { i with condition; then_ = branch i.then_; else_ = branch i.else_ } ])
  | Step _ | Loop _ | Reset _ | Start _ | Begin _ | Enter _ | Await _ | Run _ | Return _ -> raise Not_short

(* A value that stands wherever it is used: few operations on the input. *)
let most_parts = 8

let stands_for_itself e =
  let rec parts n e =
    match e with
    | Field _ -> raise Not_short
    | e -> List.fold_left parts (n + 1) (Walk.children e)
  in
  parts 0 e <= most_parts

(* The first instant: what it leaves in the state. *)
let rec first known (s : statement) =
  let let_be (variable : variable) e =
    if stands_for_itself e then Hashtbl.replace known.variables variable.id e else raise Not_short
  in
  match s with
  | Declare { variable; value = e; _ } | Assign { place = Local variable; value = e; _ } ->
      let_be variable (value known e);
      []
  | Assign { place = Own field; value = e; span } ->
      let e = value known e in
      if Option.fold (Hashtbl.find_opt known.fields field.id) ~none:false ~some:(Literal.same e) then []
      else (
        if Literal.is e then Hashtbl.replace known.fields field.id e
        else Hashtbl.remove known.fields field.id;
        [ Assign { place = Own field; value = e; span } ])
  | If { condition; then_; else_; _ } -> (
      match value known condition with
      | Bool b -> List.concat_map (first known) (if b then then_ else else_)
      | _ -> raise Not_short)
  | Assign { place = Result _; _ }
  | Step _ | Loop _ | Reset _ | Start _ | Begin _ | Enter _ | Await _ | Run _ | Return _ ->
      raise Not_short

(* The last statements that are for both: results read from the state. *)
let rec divided = function
  | [] -> ([], [])
  | (Assign { place = Result _; _ } as s) :: before ->
      let reads_more = ref false in
      Walk.expressions
        (function Variable _ | Dt | Dt_nanoseconds -> reads_more := true | _ -> ())
        [ s ];
      if !reads_more then (s :: before, [])
      else
        let before, results = divided before in
        (before, s :: results)
  | before -> (before, [])

let literals reset =
  let fields = Hashtbl.create 16 in
  List.iter
    (function
      | Assign { place = Own field; value; _ } when Literal.is value -> Hashtbl.replace fields field.id value
      | _ -> ())
    reset;
  fields

(* More than that is no shorter than asking more than once. *)
let most_statements = 4

let asks (started : field) body =
  let times = ref 0 in
  Walk.expressions (function Field f when f.id = started.id -> incr times | _ -> ()) body;
  !times > 0

let step real ~(started : field) ~reset body =
  let reversed_body, reversed_results = divided (List.rev body) in
  let body = List.rev reversed_body and results = List.rev reversed_results in
  if not (asks started body) then None
  else
    try
      let at_first = { real; first = true; fields = literals reset; variables = Hashtbl.create 16 } in
      let first = List.concat_map (first at_first) body in
      if List.length first > most_statements then None
      else
        let fields = Hashtbl.create 1 in
        Hashtbl.replace fields started.id (Bool true);
        let known = { real; first = false; fields; variables = Hashtbl.create 16 } in
        let others = List.concat_map (later known) body in
        Some
          (If
             {
               uninitialized = [];
               condition =
                 Operation { operator = Not; ty = Bool; arguments = [ Field started ] };
               then_ = first;
               else_ = others;
               predicted = false;
               span = started.span;
             }
          :: results)
    with Not_short -> None
