open Basis
module Names = Map.Make (String)

type scope = {
  types : Type.rigid Names.t;
  representations : Units.rigid Names.t;
  units : Units.rigid Names.t;
}

let empty = { types = Names.empty; representations = Names.empty; units = Names.empty }
let with_type name variable scope = { scope with types = Names.add name variable scope.types }

let of_parameters units types =
  let by_name pairs =
    List.fold_left
      (fun map ((p : Resolve.Ir.parameter), variable) -> Names.add p.name variable map)
      Names.empty pairs
  in
  { empty with units = by_name units; types = by_name types }

type t = { environment : Environment.t; supply : Type.supply; facts : Fact.t Facts.t }

let find kind names name =
  match Names.find_opt name names with
  | Some variable -> variable
  | None -> Diagnostic.bug ~stage:"Typing.Annotation" "no %s variable %s in scope" kind name

(* {1 Units} *)

(* Larger powers of a scaled unit have no practical use, and exact arithmetic on them is slow. *)
let largest_scaled_power = 8
let report_exponent t span = Facts.report t.facts (Exponent_too_large span)

let scaled_power t span (name : Ir.Global.t) scale (exponent : Rational.t) =
  if Exact.equal scale Exact.one then Exact.one
  else if not (Rational.is_integer exponent) then (
    Facts.report t.facts (Scaled_power { at = span; unit_ = name; exponent });
    Exact.one)
  else if abs exponent.numerator > largest_scaled_power then (
    report_exponent t span;
    Exact.one)
  else Exact.power scale exponent.numerator

let unit_ t scope (written : Resolve.Ir.unit_) : Environment.unit_ =
  let factor (product : Environment.unit_) (factor, exponent) : Environment.unit_ =
    match (factor : Resolve.Ir.unit_factor) with
    | Unit_variable name ->
        let variable = Units.of_rigid (find "unit" scope.units name) in
        { product with measure = Units.multiply product.measure (Units.power variable exponent) }
    | Declared name ->
        let declared = Environment.unit_ t.environment name in
        let scale = scaled_power t written.span name declared.scale exponent in
        {
          measure = Units.multiply product.measure (Units.power declared.measure exponent);
          scale =
            (if Exact.equal scale Exact.one then product.scale
             else Exact.multiply product.scale scale);
        }
  in
  let one : Environment.unit_ = { measure = Units.one; scale = Exact.one } in
  try List.fold_left factor one written.factors
  with Rational.Out_of_range ->
    report_exponent t written.span;
    one

(* Values are stored in base units, so a type has no scale. *)
let unit_of_type t scope (written : Resolve.Ir.unit_) =
  let { Environment.measure; scale } = unit_ t scope written in
  if not (Exact.equal scale Exact.one) then
    Facts.report t.facts
      (Scaled_unit_in_type { environment = t.environment; places = [ written.span ]; measure });
  measure

(* Reports identical mistakes on one line as one fact, because one fix corrects them all. *)
let together t f =
  let add merged held =
    match (Facts.fact held, merged) with
    | Fact.Scaled_unit_in_type { places; measure; _ }, (Fact.Scaled_unit_in_type u, _) :: others
      when Span.line (List.hd u.places).start = Span.line (List.hd places).start
           && Units.equal u.measure measure ->
        (Fact.Scaled_unit_in_type { u with places = u.places @ places }, None) :: others
    | fact, _ -> (fact, Some held) :: merged
  in
  let result, held = Facts.hold t.facts f in
  List.fold_left add [] held |> List.rev
  |> List.iter (fun (fact, held) ->
         match held with
         | Some held -> Facts.pass_on t.facts held
         | None -> Facts.report t.facts fact);
  result

(* {1 Sizes} *)

let largest_size = 1_048_576

let check_size t span n =
  if n < 1 || n > largest_size then
    Facts.report t.facts (Array_size { at = span; size = n; largest = largest_size })

let report_kind t span wanted found =
  Facts.report t.facts (Wrong_kind { environment = t.environment; at = span; wanted; found })

let array_parameters : Type.kind list = [ Of_sizes; Of_types ]

let is_array (tycon : Ir.Global.t) =
  let array : Ir.Global.t = Environment.array in
  String.equal tycon.name array.name && String.equal tycon.module_ array.module_

(* The kind of each parameter: a type or a size. *)
let kinds t tycon =
  if is_array tycon then array_parameters
  else
    let { Environment.parameters; _ } = Environment.type_ t.environment tycon in
    List.map (fun (r : Type.rigid) -> r.kind) parameters.types

(* {1 Types} *)

let rec any t scope (written : Resolve.Ir.ty) : Type.t =
  match written.desc with
  | Type_variable name -> Rigid (find "type" scope.types name)
  | Representation { variable; unit_ } ->
      Number
        ( Rigid_representation (find "representation" scope.representations variable),
          unit_of_type t scope unit_ )
  | Function (a, b) ->
      let a = ty t scope a in
      Function (a, ty t scope b)
  | Size n ->
      check_size t written.span n;
      Size n
  | Tuple_type elements -> Tuple (List.map (ty t scope) elements)
  | Named { tycon; units; arguments } -> named t scope tycon units arguments

and of_kind ?(reported = false) t scope kind (written : Resolve.Ir.ty) =
  match any t scope written with
  | Erroneous -> Type.Erroneous
  | found when Type.kind found = kind -> found
  | found ->
      if not reported then report_kind t written.span kind found;
      Erroneous

and ty t scope written = of_kind t scope Of_types written

and named t scope tycon units arguments =
  let units = List.map (unit_of_type t scope) units in
  let argument reported kind written =
    let found = of_kind ~reported t scope kind written in
    (reported || found = Erroneous, found)
  in
  (* Reports two swapped arguments as one mistake. *)
  let _, arguments =
    List.fold_left_map
      (fun reported (kind, written) -> argument reported kind written)
      false
      (List.combine (kinds t tycon) arguments)
  in
  let { Environment.parameters; definition } = Environment.type_ t.environment tycon in
  match definition with
  | Alias body ->
      let expansion =
        if units = [] && arguments = [] then body
        else
          Type.substitute body
            ~units:(List.combine parameters.units units)
            ~types:(List.combine parameters.types arguments)
      in
      Alias { alias = tycon; units; arguments; expansion }
  | Data _ | Foreign -> Data { tycon; units; arguments }
  | Builtin -> (
      let measure = match units with [] -> Units.one | u :: _ -> u in
      match (tycon.name, arguments) with
      | "Float", [] -> Number (Float, measure)
      | "Int", [] -> Number (Int, measure)
      | "Bool", [] -> Bool
      | "String", [] -> String
      | "SF", [ a; b ] -> Signal_function (a, b)
      | _, arguments -> Data { tycon; units; arguments })

(* {1 Signatures} *)

(* Visits the variables in order of occurrence, each type variable with the kind that its position
   requires. *)
let rec occurring t kind see (written : Resolve.Ir.ty) =
  let in_type = occurring t Type.Of_types see in
  match written.desc with
  | Type_variable name -> see (`Type (name, kind))
  | Representation { variable; unit_ } ->
      see (`Representation variable);
      occurring_in_unit see unit_
  | Function (a, b) ->
      in_type a;
      in_type b
  | Tuple_type elements -> List.iter in_type elements
  | Size _ -> ()
  | Named { tycon; units; arguments } ->
      List.iter (occurring_in_unit see) units;
      List.iter2 (fun kind -> occurring t kind see) (kinds t tycon) arguments

and occurring_in_unit see (written : Resolve.Ir.unit_) =
  List.iter
    (fun (factor, _) ->
      match (factor : Resolve.Ir.unit_factor) with
      | Unit_variable name -> see (`Unit name)
      | Declared _ -> ())
    written.factors

let parameter_kinds t (fields : Resolve.Ir.ty list) =
  let kinds = ref Names.empty in
  let see = function
    | `Type (name, kind) -> if not (Names.mem name !kinds) then kinds := Names.add name kind !kinds
    | `Representation _ | `Unit _ -> ()
  in
  List.iter (occurring t Of_types see) fields;
  fun name -> Option.value (Names.find_opt name !kinds) ~default:Type.Of_types

let class_ (name : Ir.Global.t) : Ir.class_ =
  match name with
  | { module_ = "Prelude"; name = "Eq" } -> Eq
  | { module_ = "Prelude"; name = "Ord" } -> Ord
  | _ -> Declared name

let signature t scope ~depth (written : Resolve.Ir.scheme) =
  together t @@ fun () ->
  let scope = ref scope and types = ref [] and representations = ref [] and units = ref [] in
  let variable name : Ir.variable = { id = Type.next t.supply; name } in
  let see = function
    | `Type (name, kind) ->
        if not (Names.mem name !scope.types) then (
          let rigid : Type.rigid = { variable = variable name; kind; depth } in
          types := rigid :: !types;
          scope := { !scope with types = Names.add name rigid !scope.types })
    | `Representation name ->
        if not (Names.mem name !scope.representations) then (
          let rigid : Units.rigid = { variable = variable name; depth } in
          representations := rigid :: !representations;
          scope := { !scope with representations = Names.add name rigid !scope.representations })
    | `Unit name ->
        if not (Names.mem name !scope.units) then (
          let rigid : Units.rigid = { variable = variable name; depth } in
          units := rigid :: !units;
          scope := { !scope with units = Names.add name rigid !scope.units })
  in
  let see_all = occurring t Of_types see in
  List.iter (fun (c : Resolve.Ir.constraint_) -> see_all c.argument) written.context;
  see_all written.ty;
  let scope = !scope in
  let constraint_ (c : Resolve.Ir.constraint_) = (class_ c.class_, ty t scope c.argument) in
  let context = List.map constraint_ written.context in
  let scheme : Type.scheme =
    {
      types = List.rev !types;
      representations = List.rev !representations;
      units = List.rev !units;
      context;
      body = ty t scope written.ty;
    }
  in
  (scheme, scope)

let nowhere environment : Surroundings.t =
  {
    environment;
    named = (fun _ -> []);
    values = (fun _ ~file:_ -> []);
    sources = Source.create ();
    inputs = [];
    enclosing = [];
    needs_class = (fun _ -> false);
    definition = (fun _ -> None);
    local = (fun _ -> None);
    unit_ = (fun _ -> None);
    fields = (fun _ -> None);
    field_of = (fun _ ~of_:_ -> None);
    field_type = (fun _ _ -> None);
    choices = (fun _ -> []);
    declared = (fun _ -> None);
    binding = (fun _ -> None);
    local_function = (fun _ -> None);
    parameter = (fun _ -> None);
    unnamed_input = None;
    makers = (fun _ ~of_:_ -> []);
    owner = (fun _ -> None);
  }

let report_declaration (t : t) fact =
  let around = nowhere t.environment in
  Facts.report t.facts (Declaration { around; fact })
