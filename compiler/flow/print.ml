open Format

let declare names (s : Ir.signal) = ignore (Basis.Unique_names.find names ~id:s.id s.name : string)

let names_of (node : Ir.node) =
  let names = Basis.Unique_names.create () in
  Signals.iter (declare names) node;
  names

let signal names ppf (s : Ir.signal) =
  pp_print_string ppf
    (match Basis.Unique_names.find_opt names s.id with
    | Some shown -> shown
    | None -> sprintf "<undefined %s>" s.name)

let float x =
  let short = sprintf "%.12g" x in
  let text = if Float.equal (float_of_string short) x then short else sprintf "%.17g" x in
  if String.for_all (function '0' .. '9' | '-' -> true | _ -> false) text then text ^ ".0"
  else text

let atom names ppf : Ir.atom -> unit = function
  | Signal s -> signal names ppf s
  | Bool true -> pp_print_string ppf "True"
  | Bool false -> pp_print_string ppf "False"
  | Int n -> fprintf ppf "%ld" n
  | Float x -> pp_print_string ppf (float x)

let comma ppf () = pp_print_string ppf ", "
let list pp ppf items = pp_print_list ~pp_sep:comma pp ppf items
let atoms names ppf items = list (atom names) ppf items

let operator : Ir.operator -> string = function
  | Add -> "+"
  | Subtract -> "-"
  | Multiply -> "*"
  | Negate -> "negate"
  | Absolute -> "abs"
  | Signum -> "signum"
  | Equal -> "=="
  | Less -> "<"
  | Less_equal -> "<="
  | Minimum -> "min"
  | Maximum -> "max"
  | Divide -> "/"
  | Pow -> "**"
  | Elementary e -> Core.Primitive_table.name (Elementary e)
  | Div -> "div"
  | Mod -> "mod"
  | Bitwise b -> Core.Primitive_table.name (Bitwise b)
  | To_float -> "toFloat"
  | Round -> "round"
  | Floor -> "floor"
  | Ceiling -> "ceiling"
  | Truncate -> "truncate"
  | Not -> "not"
  | And -> "&&"
  | Or -> "||"

let is_infix : Ir.operator -> bool = function
  | Add | Subtract | Multiply | Equal | Less | Less_equal | Divide | Pow | And | Or
  | Bitwise (Bit_and | Bit_or) ->
      true
  | _ -> false

let sum_name (sums : Ir.sum array) index =
  if index < Array.length sums then sums.(index).name else sprintf "<sum %d>" index

let rec ty sums : Ir.ty -> string = function
  | Bool -> "Bool"
  | Int -> "Int"
  | Float -> "Float"
  | Sum index -> sum_name sums index
  | Array (n, (Array _ as element)) -> sprintf "Array %d (%s)" n (ty sums element)
  | Array (n, element) -> sprintf "Array %d %s" n (ty sums element)
  | Foreign f -> f.foreign_name

let constructor (sums : Ir.sum array) (ty : Ir.ty) index =
  match ty with
  | Sum sum when sum < Array.length sums -> (
      match List.nth_opt sums.(sum).constructors index with
      | Some c -> c.constructor
      | None -> sprintf "<constructor %d>" index)
  | Bool | Int | Float | Sum _ | Array _ | Foreign _ -> sprintf "<constructor %d>" index

let rhs sums names ppf ~(defines : Ir.signal) : Ir.rhs -> unit = function
  | Copy a -> atom names ppf a
  | Op (op, [ a; b ]) when is_infix op ->
      fprintf ppf "%a %s %a" (atom names) a (operator op) (atom names) b
  | Op (op, arguments) -> fprintf ppf "%s(%a)" (operator op) (atoms names) arguments
  | If { condition; then_; else_ } ->
      fprintf ppf "if %a then %a else %a" (atom names) condition (atom names) then_ (atom names)
        else_
  | Construct { constructor = index; payload } ->
      fprintf ppf "%s(%a)" (constructor sums defines.ty index) (atoms names) payload
  | Is_constructor (a, index) ->
      fprintf ppf "%a ? %s" (atom names) a (constructor sums (Operands.ty a) index)
  | Payload { value; constructor = index; leaf } ->
      fprintf ppf "%a.%s.%d" (atom names) value (constructor sums (Operands.ty value) index) leaf
  | Elements elements -> fprintf ppf "[%a]" (atoms names) elements
  | Fill a -> fprintf ppf "fill %a" (atom names) a
  | Index (a, k) -> fprintf ppf "%a ! %d" (atom names) a k
  | At { array; index; default } ->
      fprintf ppf "at %a %a %a" (atom names) index (atom names) default (atom names) array
  | Replace { array; index; value } ->
      fprintf ppf "replace %a %a %a" (atom names) index (atom names) value (atom names) array
  | Delay { init; next } -> fprintf ppf "delay %a %a" (atom names) init (atom names) next
  | Param k -> fprintf ppf "param %d" k
  | Absent -> pp_print_string ppf "absent"
  | Time { restart = Bool false } -> pp_print_string ppf "time"
  | Time { restart } -> fprintf ppf "time since %a" (atom names) restart
  | Step_time -> pp_print_string ppf "step time"
  | Ticks a -> fprintf ppf "ticks %a" (atom names) a
  | Integral a -> fprintf ppf "integral %a" (atom names) a
  | Derivative a -> fprintf ppf "derivative %a" (atom names) a

let typed sums names ppf (s : Ir.signal) = fprintf ppf "%a : %s" (signal names) s (ty sums s.ty)

let equation sums names ppf (eq : Ir.equation) =
  fprintf ppf "  %a = %t@\n" (typed sums names) eq.defines (fun ppf ->
      rhs sums names ppf ~defines:eq.defines eq.rhs)

let node_name (program : Ir.program) index =
  if index < Array.length program.nodes then program.nodes.(index).name
  else sprintf "<node %d>" index

let statics names ppf = function [] -> () | some -> fprintf ppf "[%a]" (atoms names) some

let transition program modes names keyword ppf (t : Ir.transition) =
  let target =
    match List.nth_opt modes t.target with
    | Some mode -> node_name program mode
    | None -> sprintf "<mode %d>" t.target
  in
  fprintf ppf "%s %a -> %s%a%s@\n" keyword (atom names) t.occurs target (statics names) t.arguments
    (if t.delayed then ", delayed" else "")

let machine (program : Ir.program) names ppf (m : Ir.machine) =
  fprintf ppf "  (%a) = one of %s (%a)@\n"
    (list (typed program.sums names))
    m.outputs
    (String.concat ", " (List.map (node_name program) m.modes))
    (atoms names) m.inputs;
  Option.iter (fprintf ppf "    if %a@\n" (atom names)) m.active;
  List.iter (transition program m.modes names "    start" ppf) m.start;
  List.iter (transition program m.modes names "    when" ppf) m.controls

let instance (program : Ir.program) names ppf (i : Ir.instance) =
  let callee = node_name program i.node in
  let statics = statics names in
  let input ppf ((argument : Ir.argument), a) =
    let how =
      match argument with
      | Same -> ""
      | Accumulator -> "accumulate "
      | Element -> "each "
      | Counter -> "count "
    in
    fprintf ppf "%s%a" how (atom names) a
  in
  let inputs ppf () =
    match i.loop with
    | None -> atoms names ppf i.inputs
    | Some l -> list input ppf (List.combine l.arguments i.inputs)
  in
  let times = match i.loop with None -> "" | Some l -> sprintf "%d times " l.count in
  fprintf ppf "  (%a) = %s%s as %s%a(%a)@\n"
    (list (typed program.sums names))
    i.outputs times callee i.name statics i.statics inputs ();
  let given ppf = function Some a -> atom names ppf a | None -> pp_print_string ppf "_" in
  List.iter
    (fun (t : Ir.trial) ->
      fprintf ppf "    (%a) from (%a)@\n" (list (signal names)) t.gives (list given) t.given)
    i.trials

let output names ppf (name, value) = fprintf ppf "%s = %a" name (atom names) value

let node (program : Ir.program) ppf ~modes (n : Ir.node) =
  let names = names_of n in
  let sums = program.sums in
  let kind = match n.kind with Function -> "function" | Signal_function -> "signal function" in
  let statics ppf = function
    | [] -> ()
    | some -> fprintf ppf " [%a]" (list (typed sums names)) some
  in
  fprintf ppf "%s %s%a (%a)@\n" kind n.name statics n.statics (list (typed sums names)) n.inputs;
  Option.iter
    (fun (f : Ir.foreign) ->
      fprintf ppf "  (%a) = foreign %s@\n" (list (typed sums names)) f.results f.import.symbol)
    n.foreign;
  List.iter (equation sums names ppf) n.equations;
  List.iter (instance program names ppf) n.instances;
  Option.iter (machine program names ppf) n.machine;
  List.iter (transition program modes names "  when" ppf) n.transitions;
  fprintf ppf "  -> (%a)@\n" (list (output names)) n.outputs

let program ppf (p : Ir.program) =
  fprintf ppf "program %s@\n" p.name;
  let modes_of owner =
    Option.fold p.nodes.(owner).machine ~none:[] ~some:(fun (m : Ir.machine) -> m.modes)
  in
  let owners = Transitions.owners p in
  Array.iteri
    (fun index n -> node p ppf ~modes:(Option.fold owners.(index) ~none:[] ~some:modes_of) n)
    p.nodes
