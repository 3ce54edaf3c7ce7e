open Basis
module T = Typing.Ir

let binder ctx (p : T.pattern) : Ir.binder =
  match p.desc with
  | Bound local -> { local; ty = Erasure.ty p.ty }
  | Any | As _ | Tuple_of _ | Array_of _ | Constructed _ | Literal _ ->
      { local = Context.fresh ctx "" p.span; ty = Erasure.ty p.ty }

let component root index (p : T.pattern) =
  Term.make (Erasure.ty p.ty) p.span (Ir.Component (root, index))

let element root index (p : T.pattern) = Term.make (Erasure.ty p.ty) p.span (Ir.Index (root, index))

let payload root (c : T.constructor) field (p : T.pattern) =
  Term.make (Erasure.ty p.ty) p.span (Ir.Payload { value = root; constructor = c.index; field })

(* The variables of a pattern and their values, newest first. *)
let rec collect (p : T.pattern) root found =
  match p.desc with
  | Any | Literal _ -> found
  | Bound local -> ({ Ir.local; ty = root.Ir.ty }, root) :: found
  | As (local, p) ->
      (* the patterns inside an as-pattern refer to the value by the name that it binds *)
      let binder = { Ir.local; ty = root.Ir.ty } in
      collect p (Term.variable binder p.span) ((binder, root) :: found)
  | Tuple_of ps -> collect_parts (component root) ps found
  | Array_of ps -> collect_parts (element root) ps found
  | Constructed (c, ps) -> collect_parts (payload root c) ps found

and collect_parts part ps found =
  let visit (index, found) (p : T.pattern) =
    let found =
      match p.desc with
      | Any | Literal _ -> found
      | Bound _ | As _ | Tuple_of _ | Array_of _ | Constructed _ -> collect p (part index p) found
    in
    (index + 1, found)
  in
  snd (List.fold_left visit (0, found) ps)

let rec part_of (p : T.pattern) root (x : Ir.Local.t) =
  match p.desc with
  | Any | Literal _ -> None
  | Bound y -> if y.id = x.id then Some root else None
  | As (y, p) -> if y.id = x.id then Some root else part_of p root x
  | Tuple_of ps -> part_in (component root) ps x
  | Array_of ps -> part_in (element root) ps x
  | Constructed (c, ps) -> part_in (payload root c) ps x

and part_in part ps x = List.find_map Fun.id (List.mapi (fun i p -> part_of p (part i p) x) ps)

let part p ~root x = Option.get (part_of p root x)

let variables (p : T.pattern) ~root =
  match p.desc with
  | Bound _ -> []
  | Any | As _ | Tuple_of _ | Array_of _ | Constructed _ | Literal _ -> List.rev (collect p root [])

let constructor_test ctx (c : T.constructor) root (p : T.pattern) =
  match root.Ir.ty with
  | Bool -> Some (if c.index = 1 then root else Term.not_ root)
  | Data (tycon, _) when Context.constructors ctx tycon = 1 -> None
  | Data _ | Int | Float | String | Variable _ | Tuple _ | Function _ | Signal_function _ | Array _
  | Size _ ->
      Some (Term.make Bool p.span (Ir.Is_constructor (root, c.index)))

let rec tests ctx (p : T.pattern) root found =
  match p.desc with
  | Any | Bound _ -> found
  | As (_, p) -> tests ctx p root found
  | Literal value -> Term.equal root (Term.make root.ty p.span (Ir.Number value)) :: found
  | Tuple_of ps -> part_tests ctx (component root) ps found
  | Array_of ps -> part_tests ctx (element root) ps found
  | Constructed (c, ps) ->
      let found =
        match constructor_test ctx c root p with Some test -> test :: found | None -> found
      in
      part_tests ctx (payload root c) ps found

and part_tests ctx part ps found =
  let visit (index, found) (p : T.pattern) =
    let found =
      match p.desc with
      | Any | Bound _ -> found
      | As _ | Tuple_of _ | Array_of _ | Constructed _ | Literal _ ->
          tests ctx p (part index p) found
    in
    (index + 1, found)
  in
  snd (List.fold_left visit (0, found) ps)

let test ctx p ~root =
  match tests ctx p root [] with
  | [] -> None
  | last :: before ->
      Some (List.fold_left (fun rest test -> Term.conjunction test rest) last before)

type branch = { pattern : T.pattern; falls : bool; value : fall:Ir.expr option -> Ir.expr }

let bind found body = List.fold_left (fun body (b, value) -> Term.let_ b value body) body found
let with_variables (p : T.pattern) root body = bind (collect p root []) body

(* Passes [rest] to [use] as an expression that may be used in two places. *)
let shared ctx span (rest : Ir.expr) use =
  if Term.is_trivial rest then use rest
  else
    let unit : Ir.ty = Tuple [] in
    let join : Ir.binder =
      { local = Context.fresh ctx "" span; ty = Ir.Function (unit, rest.ty) }
    in
    let nothing : Ir.binder = { local = Context.fresh ctx "" span; ty = unit } in
    let jump =
      Term.apply (Term.variable join span) (Term.make unit span (Ir.Tuple [])) rest.ty span
    in
    Term.let_ join (Term.make join.ty span (Ir.Lambda (nothing, rest))) (use jump)

let branch ctx root span rest { pattern; falls; value } =
  let matched fall = with_variables pattern root (value ~fall) in
  match rest with
  | None -> matched None
  | Some rest -> (
      match (test ctx pattern ~root, falls) with
      | None, false -> matched None
      | None, true -> matched (Some rest)
      | Some test, false -> Term.if_ test (matched None) rest span
      | Some test, true ->
          shared ctx span rest (fun rest -> Term.if_ test (matched (Some rest)) rest span))

let case ctx ~root span branches =
  let chain =
    List.fold_left (fun rest b -> Some (branch ctx root span rest b)) None (List.rev branches)
  in
  match chain with
  | Some e -> e
  | None -> Diagnostic.bug ~stage:"Core.Matching" "a case has no branches"
