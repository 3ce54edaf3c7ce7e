(* Whether swapping the operands leaves the result the same, bit for bit. [Minimum] and [Maximum]
   are excluded, because they distinguish 0 and -0. *)
let is_commutative : Ir.operator -> bool = function
  | Add | Multiply | Equal | And | Or | Elementary Hypot | Bitwise (Bit_and | Bit_or | Bit_xor) ->
      true
  | _ -> false

(* Whether changing the sign of a Float operand leaves the result the same, bit for bit. *)
let is_even : Ir.operator -> bool = function Absolute | Elementary Hypot -> true | _ -> false

(* A right-hand side or an instance, without its operands. *)
type work = Equation of Ir.ty * Ir.rhs | Instance of int * Ir.loop option

module Table = Hashtbl.Make (struct
  type t = Operands.key list * work

  let equal = ( = )
  let hash = Hashtbl.hash_param 40 80
end)

let without_operand _ : Ir.atom = Bool false

(* [unsigned] returns the key of a number that equals the operand except for its sign. *)
let key_of_equation ~unsigned (e : Ir.equation) rhs =
  let key =
    match rhs with Ir.Op (operator, _) when is_even operator -> unsigned | _ -> Operands.key
  in
  let operands = Basis.Long_list.map key (Operands.all rhs) in
  let operands =
    match rhs with
    | Op (operator, _) when is_commutative operator -> List.sort compare operands
    | _ -> operands
  in
  (operands, Equation (e.defines.ty, Operands.map without_operand rhs))

(* Visits each item after the items that it reads in the same instant. Therefore a single round
   finds all equal items, except those whose equality depends on equal delays. *)
let round (node : Ir.node) =
  let first = Table.create 64 and substitution = Substitution.create () in
  let duplicates = Hashtbl.create 4 in
  (* [differences]: the key of each difference, by its operands. [negated]: if a number is the
     negation of another, maps its key to the key of the other. *)
  let differences = Hashtbl.create 16 and negated = Hashtbl.create 4 in
  let atom = Substitution.atom substitution in
  let meet key defined =
    match Table.find_opt first key with
    | None ->
        Table.replace first key defined;
        true
    | Some before ->
        List.iter2
          (fun (s : Ir.signal) t -> Substitution.replace substitution s (Ir.Signal t))
          defined before;
        false
  in
  let unsigned a =
    let key = Operands.key a in
    Option.value (Hashtbl.find_opt negated key) ~default:key
  in
  let note_sign (e : Ir.equation) rhs =
    let own = Operands.key (Signal e.defines) in
    let negates key = Hashtbl.replace negated own key in
    match (rhs : Ir.rhs) with
    | Op (Negate, [ a ]) when e.defines.ty = Float -> negates (unsigned a)
    | Op (Subtract, [ a; b ]) when e.defines.ty = Float -> (
        let a = Operands.key a and b = Operands.key b in
        match Hashtbl.find_opt differences (b, a) with
        | Some key -> negates key
        | None -> Hashtbl.replace differences (a, b) own)
    | _ -> ()
  in
  let visit : Schedule.item -> unit = function
    | Equation e ->
        let rhs = Operands.map atom e.rhs in
        note_sign e rhs;
        ignore (meet (key_of_equation ~unsigned e rhs) [ e.defines ] : bool)
    | Instance i ->
        let key a = Operands.key (atom a) in
        let operands = Basis.Long_list.map key (i.statics @ i.inputs) in
        if not (meet (operands, Instance (i.node, i.loop)) i.outputs) then
          Hashtbl.replace duplicates i.name ()
    | Trial _ | Machine _ -> ()
  in
  List.iter visit (Schedule.as_far_as_possible node);
  if Substitution.is_empty substitution && Hashtbl.length duplicates = 0 then node
  else
    let stays (i : Ir.instance) = not (Hashtbl.mem duplicates i.name) in
    Substitution.node substitution { node with instances = List.filter stays node.instances }

let rec node before =
  let after = round before in
  if after == before then before else node after

let program program = Each_node.program (fun ~fresh:_ -> node) program
