open Type

type clash =
  | Different of Type.t * Type.t
  | Different_units of Units.t * Units.t
  | Different_representations of Type.representation * Type.representation
  | Infinite of Type.t
  | Escaping
  | Out_of_range

exception Clash of clash

let clash c = raise_notrace (Clash c)

let units a b =
  if not (Units.unify a b) then clash (Different_units (Units.resolve a, Units.resolve b))

let representations a b =
  let a = Type.representation a and b = Type.representation b in
  match (a, b) with
  | Int, Int | Float, Float -> ()
  | Flexible_representation x, Flexible_representation y ->
      if x != y then (
        y.depth <- min x.depth y.depth;
        x.found <- Some b)
  | Flexible_representation x, found | found, Flexible_representation x -> (
      match found with
      | Rigid_representation r when r.depth > x.depth -> clash Escaping
      | Rigid_representation _ | Int | Float | Flexible_representation _ -> x.found <- Some found)
  | Rigid_representation x, Rigid_representation y when x.variable.id = y.variable.id -> ()
  | (Int | Float | Rigid_representation _), (Int | Float | Rigid_representation _) ->
      clash (Different_representations (a, b))

(* Checks that the variable may be set to [t] (the occurs check), and limits the depth of the
   variables in [t] to the variable's own depth. *)
let rec admit (variable : flexible) t =
  Basis.Work.step ();
  match repr t with
  | Flexible other ->
      if other == variable then clash (Infinite (Flexible variable));
      other.depth <- min other.depth variable.depth
  | Rigid r -> if r.depth > variable.depth then clash Escaping
  | Number (r, unit_) ->
      admit_representation variable r;
      admit_unit variable unit_
  | Tuple elements -> List.iter (admit variable) elements
  | Function (a, b) | Signal_function (a, b) ->
      admit variable a;
      admit variable b
  | Data { units; arguments; _ } ->
      List.iter (admit_unit variable) units;
      List.iter (admit variable) arguments
  | Alias { expansion; units; arguments; _ } ->
      if units <> [] || arguments <> [] then admit variable expansion
  | Bool | String | Size _ | Erroneous -> ()

and admit_unit variable unit_ = if not (Units.lower ~depth:variable.depth unit_) then clash Escaping

and admit_representation variable r =
  match Type.representation r with
  | Flexible_representation other -> other.depth <- min other.depth variable.depth
  | Rigid_representation r -> if r.depth > variable.depth then clash Escaping
  | Int | Float -> ()

(* Marks the unsolved variables of the type as erroneous, because the type that would have
   determined them is erroneous. *)
let rec spoil t =
  Basis.Work.step ();
  match repr t with
  | Flexible variable -> variable.found <- Some Erroneous
  | Tuple elements -> List.iter spoil elements
  | Function (a, b) | Signal_function (a, b) ->
      spoil a;
      spoil b
  | Data { arguments; _ } -> List.iter spoil arguments
  | Alias { arguments; expansion; _ } -> if arguments <> [] then spoil expansion
  | Rigid _ | Number _ | Bool | String | Size _ | Erroneous -> ()

let rec unify a b =
  Basis.Work.step ();
  let a = repr a and b = repr b in
  if a != b then
    match (a, b) with
    | Flexible x, Flexible y ->
        if x != y then (
          y.depth <- min x.depth y.depth;
          x.found <- Some b)
    | Erroneous, t | t, Erroneous -> spoil t
    | Flexible variable, t | t, Flexible variable ->
        admit variable t;
        variable.found <- Some t
    | Alias { expansion; _ }, t -> unify expansion t
    | t, Alias { expansion; _ } -> unify t expansion
    | Rigid x, Rigid y when x.variable.id = y.variable.id -> ()
    | Number (r, u), Number (r', u') ->
        representations r r';
        units u u'
    | Bool, Bool | String, String -> ()
    | Size m, Size n when m = n -> ()
    | Tuple xs, Tuple ys when List.compare_lengths xs ys = 0 -> List.iter2 unify xs ys
    | Function (x, y), Function (x', y') | Signal_function (x, y), Signal_function (x', y') ->
        unify x x';
        unify y y'
    | Data x, Data y when x.tycon = y.tycon ->
        List.iter2 units x.units y.units;
        List.iter2 unify x.arguments y.arguments
    | ( ( Rigid _ | Number _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _
        | Size _ ),
        ( Rigid _ | Number _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _
        | Size _ ) ) ->
        clash (Different (a, b))

let types a b =
  match unify a b with
  | () -> Ok ()
  | exception Clash c -> Error c
  | exception Rational.Out_of_range -> Error Out_of_range
