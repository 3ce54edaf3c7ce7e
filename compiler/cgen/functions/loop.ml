module M = Step.Ir
module V = Vocabulary

let plain desc : Ir.statement = { desc; comment = "" }

let is_array (ty : M.ty) =
  match ty with Array _ -> true | Bool | Int | Float | Sum _ | Nanoseconds | Foreign _ -> false

(* Whether an expression is cheap enough to be evaluated in every iteration. *)
let rec is_place : Ir.expr -> bool = function
  | Name _ | Boolean _ | Integer _ | Long _ | Float _ -> true
  | Member (e, _) | Arrow (e, _) | Unary ((Address | Dereference), e) -> is_place e
  | Subscript (e, index) -> is_place e && is_place index
  | Unary ((Negate | Not), _) | Binary _ | Conditional _ | Call _ | Cast _ | Aggregate _ -> false

let statements names (l : M.loop) ~call =
  let v = Expression.vocabulary names and scope = Expression.scope names in
  let callee = v.program.nodes.(l.node) in
  let accumulators = List.length l.initial in
  let result_names = List.map (Expression.variable names) l.results in
  let start name (variable : M.variable) initial =
    plain (Ir.Variable { ty = V.ty v variable.ty; name; value = Expression.of_step names initial })
  in
  let declare k (variable : M.variable) =
    let name = List.nth result_names k in
    match List.nth_opt l.initial k with
    | Some initial -> start name variable initial
    | None -> plain (Ir.Variables { ty = V.ty v variable.ty; names = [ name ] })
  in
  let declarations = List.mapi declare l.results in
  let index = Expression.index names 0 in
  let before = ref [] in
  let once (p : M.variable) e =
    let e = Expression.of_step names e in
    if is_array p.ty then Expression.address e
    else if is_place e then e
    else
      let name = Name.fresh scope p.name in
      before := plain (Ir.Constant { ty = V.ty v p.ty; name; value = e }) :: !before;
      Ir.Name name
  in
  let argument (p : M.variable) (argument : M.argument) : Ir.expr =
    match argument with
    | Accumulated k ->
        let name : Ir.expr = Name (List.nth result_names k) in
        if is_array p.ty then Expression.address name else name
    | Same e -> once p e
    | Counted (Int 0l) -> Name index
    | Counted e -> Call ("frob_int_add", [ Expression.of_step names e; Name index ])
    | Each e ->
        let element = Expression.element names e (Name index) in
        if is_array p.ty then Expression.address element else element
  in
  let arguments = List.map2 argument callee.step.parameters l.arguments in
  let target k name : Ir.expr =
    if k < accumulators then Name name else Array_type.element (Name name) (Name index)
  in
  let targets = List.mapi target result_names in
  let body =
    match targets with
    | [ target ] -> [ plain (Ir.Assign (target, call index arguments [])) ]
    | targets ->
        (* An array accumulator is read while its next value is written, so it needs a second
           variable. *)
        let next k (variable : M.variable) target =
          if k < accumulators && is_array variable.ty then
            let name = Name.fresh scope "next" in
            ( Ir.Name name,
              [ plain (Ir.Variables { ty = V.ty v variable.ty; names = [ name ] }) ],
              [ plain (Ir.Assign (target, Name name)) ] )
          else (target, [], [])
        in
        let places =
          List.mapi
            (fun k (variable, target) -> next k variable target)
            (List.combine l.results targets)
        in
        let given = List.map (fun (place, _, _) -> Expression.address place) places in
        List.concat_map (fun (_, declared, _) -> declared) places
        @ [ plain (Ir.Do (call index arguments given)) ]
        @ List.concat_map (fun (_, _, assigned) -> assigned) places
  in
  declarations @ List.rev !before @ [ plain (Ir.For { index; count = l.count; body }) ]
