open Basis

(* The simplified right-hand sides of the preceding equations, by signal id. *)
type known = Ir.rhs Int_table.t

let definition (known : known) : Ir.atom -> Ir.rhs option = function
  | Signal s -> Int_table.find_opt known s.id
  | Bool _ | Int _ | Float _ -> None

let same = Operands.same

let is_int : Ir.atom -> bool = function
  | Int _ -> true
  | Signal s -> s.ty = Int
  | Bool _ | Float _ -> false

(* Whether the value is certain to equal itself, because it cannot be NaN. *)
let is_no_float : Ir.atom -> bool = function
  | Int _ | Bool _ -> true
  | Signal s -> s.ty <> Float
  | Float _ -> false

let positive_zero (a : Ir.atom) = same a (Float 0.)
let negative_zero (a : Ir.atom) = same a (Float (-0.))

(* Whether the second atom is the negation of the first. *)
let is_not known a b =
  match (definition known b, (a : Ir.atom)) with
  | Some (Op (Not, [ a' ])), Signal _ -> same a a'
  | _, _ -> false

(* [(if c then x else b) && not b] equals [c && (x && not b)]. Returns [Some (c, x)] for such a
   choice. *)
let excluding_else known choice other =
  match definition known choice with
  | Some (If { condition; then_; else_ }) when is_not known else_ other -> Some (condition, then_)
  | Some _ | None -> None

let operation known add ~unchanged (operator : Ir.operator) (arguments : Ir.atom list) : Ir.rhs =
  match (operator, arguments) with
  | Add, ([ a; Int 0l ] | [ Int 0l; a ]) -> Copy a
  | Add, [ a; zero ] when negative_zero zero -> Copy a
  | Add, [ zero; a ] when negative_zero zero -> Copy a
  | Subtract, [ a; Int 0l ] -> Copy a
  | Subtract, [ a; zero ] when positive_zero zero -> Copy a
  | Subtract, [ a; b ] when is_int a && same a b -> Copy (Int 0l)
  | Multiply, ([ _; Int 0l ] | [ Int 0l; _ ]) -> Copy (Int 0l)
  | Multiply, ([ a; (Int 1l | Float 1.) ] | [ (Int 1l | Float 1.); a ]) -> Copy a
  | Divide, [ a; Float 1. ] | Div, [ a; Int 1l ] -> Copy a
  | (Minimum | Maximum), [ a; b ] when same a b -> Copy a
  | (Equal | Less_equal), [ a; b ] when is_no_float a && same a b -> Copy (Bool true)
  | Less, [ a; b ] when same a b -> Copy (Bool false)
  | (And | Or), [ a; b ] when same a b -> Copy a
  | Equal, ([ a; Bool true ] | [ Bool true; a ]) -> Copy a
  | Equal, ([ a; Bool false ] | [ Bool false; a ]) -> Op (Not, [ a ])
  | And, ([ a; Bool true ] | [ Bool true; a ]) -> Copy a
  | And, ([ _; Bool false ] | [ Bool false; _ ]) -> Copy (Bool false)
  | And, [ a; b ] -> (
      let both (condition, x) other =
        Ir.Op (And, [ condition; add (Bool : Ir.ty) (Ir.Op (And, [ x; other ])) ])
      in
      match (excluding_else known a b, excluding_else known b a) with
      | Some choice, _ -> both choice b
      | None, Some choice -> both choice a
      | None, None -> unchanged)
  | Or, ([ a; Bool false ] | [ Bool false; a ]) -> Copy a
  | Or, ([ _; Bool true ] | [ Bool true; _ ]) -> Copy (Bool true)
  | (Not | Negate), [ a ] -> (
      match definition known a with
      | Some (Op (inner, [ b ])) when inner = operator -> Copy b
      | Some _ | None -> unchanged)
  | _ -> unchanged

(* Simplifies an atom under the assumption that the condition has this value. *)
let given known condition value atom =
  match definition known atom with
  | Some (If c) when same c.condition condition -> if value then c.then_ else c.else_
  | Some _ | None -> atom

let rec choice known condition then_ else_ : Ir.rhs =
  match ((condition : Ir.atom), definition known condition) with
  | Bool true, _ -> Copy then_
  | Bool false, _ -> Copy else_
  | _, Some (Op (Not, [ positive ])) -> choice known positive else_ then_
  | (Int _ | Float _ | Signal _), _ -> (
      let then_ = given known condition true then_ and else_ = given known condition false else_ in
      if same then_ else_ then Copy then_
      else
        match ((then_ : Ir.atom), (else_ : Ir.atom)) with
        | Bool true, Bool false -> Copy condition
        | Bool false, Bool true -> Op (Not, [ condition ])
        | _ when is_not known then_ else_ -> Op (Equal, [ condition; then_ ])
        | _ -> If { condition; then_; else_ })

(* Maximum depth of nested choices, which come from a [case] within a [case]; deeper ones are left
   unchanged. *)
let deepest = 16

(* Converts a right-hand side to an atom: adds an equation for it, unless it is a [Copy]. *)
let atom (add : Ir.ty -> Ir.rhs -> Ir.atom) ty (rhs : Ir.rhs) =
  match rhs with Copy a -> a | rhs -> add ty rhs

(* A right-hand side that tells whether an atom has a constructor, if that can be decided without
   reading the atom's tag. *)
let has_constructor known add value constructor : Ir.rhs option =
  let rec test depth value : Ir.rhs option =
    match definition known value with
    | Some (Construct c) -> Some (Copy (Bool (c.constructor = constructor)))
    | Some (If { condition; then_; else_ }) when depth < deepest -> (
        match (test (depth + 1) then_, test (depth + 1) else_) with
        | Some then_, Some else_ ->
            let then_ = atom add Bool then_ in
            Some (choice known condition then_ (atom add Bool else_))
        | None, _ | _, None -> None)
    | Some _ | None -> None
  in
  test 0 value

(* The leaf of a payload. For values with a different constructor, the leaf is unspecified.
   Therefore, if only one branch of a choice has the constructor, that branch is used, and if
   neither has it, the result is 0 or False. *)
let payload known add ty value constructor leaf : Ir.rhs option =
  let rec part depth value =
    match definition known value with
    | Some (Ir.Construct c) when c.constructor = constructor ->
        `Leaf (Ir.Copy (List.nth c.payload leaf))
    | Some (Construct _) -> `Other_constructor
    | Some (If { condition; then_; else_ }) when depth < deepest -> (
        match (part (depth + 1) then_, part (depth + 1) else_) with
        | `Leaf a, `Leaf b ->
            let a = atom add ty a in
            `Leaf (choice known condition a (atom add ty b))
        | `Leaf a, `Other_constructor | `Other_constructor, `Leaf a -> `Leaf a
        | `Other_constructor, `Other_constructor -> `Other_constructor
        | `Unknown, _ | _, `Unknown -> `Unknown)
    | Some _ | None -> `Unknown
  in
  match (part 0 value, (ty : Ir.ty)) with
  | `Leaf rhs, _ -> Some rhs
  | `Other_constructor, Bool -> Some (Copy (Bool false))
  | `Other_constructor, Int -> Some (Copy (Int 0l))
  | `Other_constructor, Float -> Some (Copy (Float 0.))
  | (`Other_constructor | `Unknown), _ -> None

let element known array k : Ir.rhs option =
  match definition known array with
  | Some (Elements elements) -> Some (Copy (List.nth elements k))
  | Some (Fill a) -> Some (Copy a)
  | Some _ | None -> None

let size : Ir.atom -> int = function
  | Signal { ty = Array (n, _); _ } -> n
  | Signal _ | Bool _ | Int _ | Float _ -> 0

let simplify real known written add (defines : Ir.signal) (rhs : Ir.rhs) : Ir.rhs =
  match rhs with
  | Op (operator, arguments) -> (
      match Fold.operation real operator arguments with
      | Some constant -> Copy constant
      | None -> operation known (add defines) ~unchanged:rhs operator arguments)
  | If { condition; then_; else_ } -> (
      match choice known condition then_ else_ with
      | If c when c.condition == condition && c.then_ == then_ && c.else_ == else_ -> rhs
      | simpler -> simpler)
  | Is_constructor (value, constructor) ->
      Option.value (has_constructor known (add defines) value constructor) ~default:rhs
  | Payload { value; constructor; leaf } ->
      Option.value (payload known (add defines) defines.ty value constructor leaf) ~default:rhs
  | Delay { init = Bool true; next = Bool false } ->
      (* Uses the negation of the opposite delay, so that all delays that mark the first instant
         become identical. *)
      Op (Not, [ add defines Bool (Delay { init = Bool false; next = Bool true }) ])
  | Delay { init; next } when same next init || same next (Signal defines) ->
      (* [init] is static, so the delay is constant. *)
      Copy init
  | Delay { init = Bool first; next } -> (
      (* Delays the operand of the negation instead. The operand exists anyway, and several delays
         of it can be merged. *)
      match definition (Lazy.force written) next with
      | Some (Op (Not, [ next ])) ->
          Op (Not, [ add defines Bool (Delay { init = Bool (not first); next }) ])
      | Some _ | None -> rhs)
  | Ticks (Float period) when Float.is_nan period -> Copy (Bool false)
  | Ticks (Float period) when period < 1. -> Copy (Bool true)
  | Time { restart = Bool true } -> Copy (Float 0.)
  | Index (array, k) -> Option.value (element known array k) ~default:rhs
  | At { array; index = Int k; default } ->
      let k = Int32.to_int k in
      if k < 0 || k >= size array then Copy default
      else Option.value (element known array k) ~default:(Ir.Index (array, k))
  | Replace { array; index = Int k; value = _ }
    when Int32.to_int k < 0 || Int32.to_int k >= size array ->
      Copy array
  | _ -> rhs

(* If all elements of an input array are equal, passes the element instead of the array. *)
let of_loop known atom (i : Ir.instance) =
  let all_equal array =
    match definition known (atom array) with
    | Some (Fill a) -> Some a
    | Some (Elements (a :: others)) when List.for_all (same a) others -> Some a
    | Some _ | None -> None
  in
  let given (how : Ir.argument) input =
    match if how = Element then all_equal input else None with
    | Some a -> (Ir.Same, a)
    | None -> (how, input)
  in
  match i.loop with
  | None -> i
  | Some l ->
      let arguments, inputs = List.split (List.map2 given l.arguments i.inputs) in
      if arguments = l.arguments then i else { i with inputs; loop = Some { l with arguments } }

let node real ~fresh (node : Ir.node) =
  let known : known = Int_table.create 64 in
  (* Lazy, because only a few equations need it. *)
  let written : known Lazy.t =
    lazy
      (let written = Int_table.create 64 in
       let write (e : Ir.equation) = Int_table.replace written e.defines.id e.rhs in
       List.iter write node.equations;
       written)
  in
  let substitution = Substitution.create () in
  let added = ref [] and changed = ref false in
  let add (like : Ir.signal) ty rhs : Ir.atom =
    let id = fresh () in
    let defines : Ir.signal = { id; name = ""; ty; group = id; span = like.span } in
    Int_table.replace known id rhs;
    added := { Ir.defines; rhs; span = like.span } :: !added;
    Signal defines
  in
  let visit = function
    | Schedule.Instance _ | Trial _ | Machine _ -> ()
    | Equation e -> (
        let rhs = Operands.map (Substitution.atom substitution) e.rhs in
        let rhs = simplify real known written add e.defines rhs in
        if rhs != e.rhs then changed := true;
        match rhs with
        | Copy a ->
            changed := true;
            Substitution.replace substitution e.defines a
        | rhs -> Int_table.replace known e.defines.id rhs)
  in
  List.iter visit (Schedule.as_far_as_possible node);
  let loop = of_loop known (Substitution.atom substitution) in
  let instances = Long_list.map_sharing loop node.instances in
  if (not !changed) && instances == node.instances then node
  else
    let equations =
      List.filter_map
        (fun (e : Ir.equation) ->
          Option.map
            (fun rhs -> if rhs == e.rhs then e else { e with rhs })
            (Int_table.find_opt known e.defines.id))
        node.equations
    in
    let equations = List.rev_append !added equations in
    Substitution.node substitution { node with equations; instances }

let program (program : Ir.program) = Each_node.program (node program.real) program

let after change (program : Ir.program) =
  let pass ~fresh before =
    let changed = change before in
    if changed == before then before else node program.real ~fresh changed
  in
  Each_node.program pass program
