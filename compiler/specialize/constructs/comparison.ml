open Basis
module Ir = Flow.Ir

type position = Evaluator.position

let define (p : position) target rhs = Node.define p.node target ~span:p.span Bool rhs

(* Folds operations on constants, so that this stage can select the code that depends on the
   result. *)
let operate (p : position) target operator atoms =
  match Flow.Fold.operation p.context.real operator atoms with
  | Some known -> known
  | None -> define p target (Op (operator, atoms))

let not_ p target (a : Ir.atom) : Ir.atom =
  match a with Bool a -> Bool (not a) | Signal _ | Int _ | Float _ -> operate p target Not [ a ]

let and_ p target (a : Ir.atom) (b : Ir.atom) : Ir.atom =
  match (a, b) with
  | Bool false, _ | _, Bool false -> Bool false
  | Bool true, other | other, Bool true -> other
  | (Signal _ | Int _ | Float _), _ -> operate p target And [ a; b ]

let or_ p target (a : Ir.atom) (b : Ir.atom) : Ir.atom =
  match (a, b) with
  | Bool true, _ | _, Bool true -> Bool true
  | Bool false, other | other, Bool false -> other
  | (Signal _ | Int _ | Float _), _ -> operate p target Or [ a; b ]

let if_ p target condition (then_ : Ir.atom) (else_ : Ir.atom) : Ir.atom =
  match (condition : Ir.atom) with
  | Bool true -> then_
  | Bool false -> else_
  | Signal _ | Int _ | Float _ -> define p target (If { condition; then_; else_ })

let has (p : position) ty value index =
  Leaves.is_constructor p.types p.node Unnamed ~span:p.span ty value index

let fields (p : position) ty value constructor parts =
  List.mapi
    (fun field (part : Types.part) ->
      (part.ty, Leaves.payload p.types p.node Unnamed ~span:p.span ty value ~constructor ~field))
    parts

(* The pairs of corresponding fields of two values that both have this constructor. *)
let field_pairs p ty a b constructor parts =
  let of_a = fields p ty a constructor parts in
  List.map2 (fun (ty, a) (_, b) -> (ty, a, b)) of_a (fields p ty b constructor parts)

let part_pairs parts a b =
  List.mapi
    (fun i (part : Types.part) -> (part.ty, Leaves.component a i, Leaves.component b i))
    parts

let numbers (p : position) ty a b = List.map (Leaves.atom p.types p.node ~span:p.span ty) [ a; b ]

let refuse ty =
  Diagnostic.bug ~stage:"Specialize.Comparison" "values of type %s cannot be compared"
    (Types.to_string ty)

(* Drawings and values of type [Text] do not affect what a program computes, so they always compare
   as equal. *)
let is_only_shown ty = Types.is_drawing ty || Types.is_text ty

let rec equal (p : position) target ty a b : Ir.atom =
  match ((Types.layout p.types ty).kind, ty) with
  | _ when is_only_shown ty -> Bool true
  | Scalar, Bool -> (
      match numbers p ty a b with
      | [ a; b ] -> if_ p target a b (not_ p Node.Unnamed b)
      | _ -> refuse ty)
  | Scalar, _ -> operate p target Equal (numbers p ty a b)
  | Product parts, _ -> equal_parts p target (part_pairs parts a b)
  | Sum constructors, _ ->
      (* distinguish the constructors of [a]; the last one needs no test *)
      let rec from index =
        let both =
          lazy
            (let test = has p ty b index in
             let pairs = field_pairs p ty a b index constructors.(index) in
             and_ p Node.Unnamed test (equal_parts p Node.Unnamed pairs))
        in
        if index = Array.length constructors - 1 then Lazy.force both
        else
          let target = if index = 0 then target else Node.Unnamed in
          let test = has p ty a index in
          let then_ = Lazy.force both in
          if_ p target test then_ (from (index + 1))
      in
      from 0
  | Array (count, element), _ -> equal_arrays p target ~count element a b
  | Opaque, _ -> refuse ty

and equal_parts p target pairs : Ir.atom =
  match pairs with
  | [] -> Bool true
  | [ (ty, a, b) ] -> equal p target ty a b
  | (ty, a, b) :: others ->
      let first = equal p Node.Unnamed ty a b in
      and_ p target first (equal_parts p Node.Unnamed others)

(* Loops over two arrays. The accumulator is true as long as all elements so far are equal. *)
and equal_arrays p target ~count element a b : Ir.atom =
  let round p values : Value.t list =
    match values with
    | [ Value.Atom same; a; b ] ->
        [ Atom (and_ p Node.Unnamed same (equal p Node.Unnamed element a b)) ]
    | _ -> refuse element
  in
  match compare_arrays p [ target ] ~name:"equal" ~count element [ Ir.Bool true ] a b round with
  | [ Value.Atom same ] -> same
  | _ -> refuse element

(* A loop over the elements of two arrays, whose accumulators are Bools with these initial
   values. *)
and compare_arrays (p : position) targets ~name ~count element initial a b round =
  let local name : Core.Ir.Local.t = { id = 0; name; span = p.span } in
  let accumulator initial : Loop.argument =
    { form = Accumulator; ty = Bool; value = Atom initial; local = local "so_far" }
  in
  let each name value : Loop.argument =
    { form = Element; ty = element; value; local = local name }
  in
  Loop.run p targets
    {
      name;
      kind = Function;
      count;
      key = name;
      captured = [];
      arguments = List.map accumulator initial @ [ each "a" a; each "b" b ];
      final = List.map (fun _ : Core.Ir.ty -> Bool) initial;
      elements = [];
    }
    (fun p _ values -> round p values)

(* The differences between [<] and [<=]: the operator on numbers, and the result for products whose
   parts are all equal. *)
type order = { of_scalars : Ir.operator; of_equals : bool }

let strict = { of_scalars = Less; of_equals = false }
let weak = { of_scalars = Less_equal; of_equals = true }

let rec ordered (p : position) order target ty a b : Ir.atom =
  match ((Types.layout p.types ty).kind, ty) with
  | _ when is_only_shown ty -> Bool order.of_equals
  | Scalar, Bool -> (
      match numbers p ty a b with
      | [ a; b ] ->
          if order.of_equals then or_ p target (not_ p Node.Unnamed a) b
          else and_ p target (not_ p Node.Unnamed a) b
      | _ -> refuse ty)
  | Scalar, _ -> operate p target order.of_scalars (numbers p ty a b)
  | Product parts, _ -> ordered_parts p order target (part_pairs parts a b)
  | Sum constructors, _ ->
      (* [from index b_before] is the result if [a] has constructor [index] or a later one.
         [b_before]: does [b] have a constructor before [index]? *)
      let last = Array.length constructors - 1 in
      let rec from index b_before =
        let pairs = field_pairs p ty a b index constructors.(index) in
        let same = ordered_parts p order Node.Unnamed pairs in
        let b_has = has p ty b index in
        let here =
          if index = last then and_ p Node.Unnamed b_has same
          else if_ p Node.Unnamed b_has same (not_ p Node.Unnamed b_before)
        in
        if index = last then here
        else
          let target = if index = 0 then target else Node.Unnamed in
          let test = has p ty a index in
          let later = from (index + 1) (or_ p Node.Unnamed b_before b_has) in
          if_ p target test here later
      in
      from 0 (Bool false)
  | Array (count, element), _ -> ordered_arrays p order target ~count element a b
  | Opaque, _ -> refuse ty

and ordered_parts p order target pairs : Ir.atom =
  match pairs with
  | [] -> Bool order.of_equals
  | [ (ty, a, b) ] -> ordered p order target ty a b
  | (ty, a, b) :: others ->
      let less = ordered p strict Node.Unnamed ty a b in
      let equal = equal p Node.Unnamed ty a b in
      let rest = ordered_parts p order Node.Unnamed others in
      or_ p target less (and_ p Node.Unnamed equal rest)

(* Loops over two arrays. One accumulator is true if the elements so far make the first array less
   than the second; the other one is true if they are all equal. *)
and ordered_arrays p order target ~count element a b : Ir.atom =
  let round p values : Value.t list =
    match values with
    | [ Value.Atom less; Atom same; a; b ] ->
        let is_less = ordered p strict Node.Unnamed element a b in
        let is_same = equal p Node.Unnamed element a b in
        [
          Atom (or_ p Node.Unnamed less (and_ p Node.Unnamed same is_less));
          Atom (and_ p Node.Unnamed same is_same);
        ]
    | _ -> refuse element
  in
  let targets = [ (if order.of_equals then Node.Unnamed else target); Node.Unnamed ] in
  match
    compare_arrays p targets ~name:"order" ~count element [ Ir.Bool false; Bool true ] a b round
  with
  | [ Value.Atom less; Atom same ] -> if order.of_equals then or_ p target less same else less
  | _ -> refuse element

let less p target ty a b = ordered p strict target ty a b
let less_equal p target ty a b = ordered p weak target ty a b
