open Basis
module Ir = Flow.Ir

let bug primitive =
  Diagnostic.bug ~stage:"Specialize.Drawing" "`%s` has unexpected arguments"
    (Core.Primitive_table.name primitive)

type drawing = { count : Ir.atom; marks : Ir.atom }

let apply (p : Evaluator.position) target (primitive : Core.Primitive.t) ~result
    (arguments : Value.argument list) : Value.t =
  let define ty rhs = Node.define p.node Unnamed ~span:p.span ty rhs in
  let leaf ty : Ir.ty =
    match (Types.layout p.types ty).leaves with
    | [ { leaf; _ } ] -> leaf
    | [] | _ :: _ :: _ -> bug primitive
  in
  let drawing (a : Value.argument) =
    match Leaves.atoms p.types p.node ~span:p.span a.ty a.value with
    | [ count; marks ] -> { count; marks }
    | _ -> bug primitive
  in
  let value { count; marks } = Leaves.value p.types result [ count; marks ] in
  let on_marks most ~add =
    let slot = leaf Types.slot in
    let marks_type = Ir.Array (most, slot) in
    let next count n : Ir.atom =
      match (count : Ir.atom) with
      | Int count -> Int (Int32.add count n)
      | Signal _ | Bool _ | Float _ -> define Int (Op (Add, [ count; Int n ]))
    in
    let put marks index value = define marks_type (Replace { array = marks; index; value }) in
    add ~slot ~marks_type ~next ~put
  in
  if primitive = Drawn then p.context.draws <- true;
  match (primitive, arguments, Types.marks p.types) with
  | (Text_of | Blank | Drawn | Together), _, None -> Product [||]
  | Text_of, [ { value = Text says; _ } ], Some _ ->
      let constructor = Types.text p.types says in
      let ty = leaf result in
      Atom (Node.define p.node target ~span:p.span ty (Construct { constructor; payload = [] }))
  | Blank, [], Some most ->
      on_marks most ~add:(fun ~slot ~marks_type ~next:_ ~put:_ ->
          let none = define slot (Construct { constructor = 0; payload = [] }) in
          value { count = Int 0l; marks = define marks_type (Fill none) })
  | Drawn, [ mark; below ], Some most ->
      on_marks most ~add:(fun ~slot ~marks_type:_ ~next ~put ->
          let mark = Leaves.atoms p.types p.node ~span:p.span mark.ty mark.value in
          let { count; marks } = drawing below in
          let mark = define slot (Construct { constructor = 1; payload = mark }) in
          value { count = next count 1l; marks = put marks count mark })
  | Together, [ below; above ], Some most ->
      on_marks most ~add:(fun ~slot ~marks_type:_ ~next ~put ->
          let below = drawing below and above = drawing above in
          let add marks k =
            put marks (next below.count (Int32.of_int k)) (define slot (Index (above.marks, k)))
          in
          let marks = List.fold_left add below.marks (List.init most Fun.id) in
          value { count = define Int (Op (Add, [ below.count; above.count ])); marks })
  | _, _, _ -> bug primitive
