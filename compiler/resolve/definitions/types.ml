open Basis
open Interface

type variables =
  | Quantified
  | Parameters of { units : String_set.t; types : String_set.t; owner : string }

let missing span : Ir.ty = { desc = Tuple_type []; span }

(* Units *)

let rec gcd a b = if b = 0 then abs a else gcd b (a mod b)

let times (a : Syntax.Ir.rational) (b : Syntax.Ir.rational) : Syntax.Ir.rational =
  let numerator = a.numerator * b.numerator and denominator = a.denominator * b.denominator in
  let divisor = gcd numerator denominator in
  { numerator = numerator / divisor; denominator = denominator / divisor }

let whole numerator : Syntax.Ir.rational = { numerator; denominator = 1 }

(* The factors of a unit with their powers, in source order. *)
let factors (unit_ : Syntax.Ir.unit_) =
  let rec add power (u : Syntax.Ir.unit_) reversed =
    match u.desc with
    | One -> reversed
    | Unit_name name -> (name, power) :: reversed
    | Times (a, b) -> add power b (add power a reversed)
    | Over (a, b) -> add (times power (whole (-1))) b (add power a reversed)
    | To (a, exponent) -> add (times power exponent) a reversed
  in
  List.rev (add (whole 1) unit_ [])

(* A lower-case letter, optionally followed by digits or primes. *)
let may_be_variable text =
  let rest = String.sub text 1 (String.length text - 1) in
  (match text.[0] with 'a' .. 'z' -> true | _ -> false)
  && String.for_all (function '0' .. '9' | '\'' -> true | _ -> false) rest

let factor (scope : Scope.t) ~variable (name, power) =
  match Scope.look scope units name with
  | Some entry -> Some (Ir.Declared entry.global, power)
  | None when may_be_variable name.text ->
      variable name;
      Some (Ir.Unit_variable name.text, power)
  | None ->
      ignore (Lookup.find scope units { qualifier = None; name; span = name.span });
      None

let unit_with scope ~variable (u : Syntax.Ir.unit_) : Ir.unit_ =
  { factors = List.filter_map (factor scope ~variable) (factors u); span = u.span }

let concrete_unit (scope : Scope.t) u =
  let variable name = Context.report_unresolved scope.context (Variable_for_unit name) in
  unit_with scope ~variable u

let report (scope : Scope.t) = Context.report_type scope.context

let unit_ (scope : Scope.t) variables u =
  let variable (name : Syntax.Ir.name) =
    match variables with
    | Parameters { units; owner; _ } when not (String_set.mem name.text units) ->
        report scope (Parameter_missing { name; owner; is_unit = true })
    | Parameters _ | Quantified -> ()
  in
  unit_with scope ~variable u

(* Types *)

let check_arity (scope : Scope.t) at (tycon : tycon) ~units ~types =
  let units_right = units = tycon.unit_arity || (units = 0 && tycon.units_optional) in
  let types_right = types = tycon.type_arity in
  let wrong ~of_units expected found =
    report scope (Wrong_arity { at; tycon; of_units; expected; found; text = scope.visible.text })
  in
  if not units_right then wrong ~of_units:true tycon.unit_arity units;
  if not types_right then wrong ~of_units:false tycon.type_arity types;
  units_right && types_right

(* Gives the arguments after a bare name that has type parameters to that name: `SF Bool (Event ())`
   for `SF Bool Event ()`. [None] if this does not result in the expected number of arguments. *)
let regrouped (scope : Scope.t) ~expected arguments =
  let rec one : Syntax.Ir.ty list -> _ = function
    | ({ desc = Type { name; units; arguments = [] }; span } as t) :: rest -> (
        match Lookup.find scope tycons name with
        | Some { type_arity = n; _ } when n > 0 ->
            Option.bind (several n rest) (fun (inner, rest) ->
                let last = List.nth inner (n - 1) in
                let span = Span.merge span (last : Syntax.Ir.ty).span in
                Some
                  (({ desc = Type { name; units; arguments = inner }; span } : Syntax.Ir.ty), rest))
        | Some _ | None -> Some (t, rest))
    | t :: rest -> Some (t, rest)
    | [] -> None
  and several n arguments =
    if n = 0 then Some ([], arguments)
    else
      Option.bind (one arguments) (fun (first, rest) ->
          Option.map (fun (others, rest) -> (first :: others, rest)) (several (n - 1) rest))
  in
  match several expected arguments with Some (grouped, []) -> Some grouped | _ -> None

(* The places of the arguments that need parentheses: those that were grouped, and inside them. *)
let rec grouped_places ~written arguments =
  let place (t : Syntax.Ir.ty) =
    match t.desc with
    | Type { arguments; _ } when not (List.memq t written) ->
        t.span :: grouped_places ~written arguments
    | _ -> []
  in
  List.concat_map place arguments

let rec ty (scope : Scope.t) variables (t : Syntax.Ir.ty) : Ir.ty =
  Context.nested scope.context t.span ~otherwise:(missing t.span) (fun () ->
      { (missing t.span) with desc = desc scope variables t })

and desc scope variables (t : Syntax.Ir.ty) : Ir.ty_desc =
  match t.desc with
  | Type_variable name ->
      (match variables with
      | Parameters { types; owner; _ } when not (String_set.mem name.text types) ->
          report scope (Parameter_missing { name; owner; is_unit = false })
      | Parameters _ | Quantified -> ());
      Type_variable name.text
  | Type { name; units; arguments } -> (
      let units = Long_list.map (unit_ scope variables) (Option.value units ~default:[]) in
      match Lookup.find scope tycons name with
      | None ->
          List.iter (fun t -> ignore (ty scope variables t)) arguments;
          Tuple_type []
      | Some tycon ->
          let expected = tycon.type_arity in
          let grouped =
            if List.length arguments > expected then regrouped scope ~expected arguments else None
          in
          Option.iter
            (fun grouped ->
              let places = grouped_places ~written:arguments grouped in
              report scope
                (Ungrouped_arguments
                   {
                     at = t.span;
                     tycon;
                     found = List.length arguments;
                     places;
                     text = scope.visible.text;
                   }))
            grouped;
          let arguments =
            Long_list.map (ty scope variables) (Option.value grouped ~default:arguments)
          in
          let types = List.length arguments in
          if check_arity scope t.span tycon ~units:(List.length units) ~types then
            let units =
              if units = [] && tycon.units_optional && not (is_builtin tycon) then
                [ ({ factors = []; span = t.span } : Ir.unit_) ]
              else units
            in
            Named { tycon = tycon.global; units; arguments }
          else Tuple_type [])
  | Representation { name; unit_ = u } ->
      (match variables with
      | Quantified -> ()
      | Parameters { owner; _ } -> report scope (Representation_without_parameter { name; owner }));
      Representation { variable = name.text; unit_ = unit_ scope variables u }
  | Function (a, b) ->
      let a = ty scope variables a in
      Function (a, ty scope variables b)
  | Tuple_type ts -> Tuple_type (Long_list.map (ty scope variables) ts)
  | Size n -> Size n
  | Size_operation _ -> (
      (* after an error, the size does not matter *)
      match known_size scope t with
      | Some n -> Size n
      | None -> Size 1)

(* The value of a size that contains arithmetic. Reports an operand whose value is not known. *)
and known_size scope (t : Syntax.Ir.ty) =
  match t.desc with
  | Size n -> Some n
  | Type { name; units = None; arguments = [] } ->
      Option.bind (Lookup.find scope tycons name) (fun (alias : tycon) ->
          if alias.size = None then
            report scope (Size_not_a_number { at = t.span; alias = Some name.name.text });
          alias.size)
  | Size_operation { operator; left; right } -> (
      match (known_size scope left, known_size scope right) with
      | Some left, Some right -> Some (size_operation operator left right)
      | _ -> None)
  | Type_variable name ->
      report scope
        (Size_of_variable { at = t.span; variable = name.text; text = scope.visible.text });
      None
  | Type _ | Representation _ | Function _ | Tuple_type _ ->
      report scope (Size_not_a_number { at = t.span; alias = None });
      None

(* Signatures *)

let constraint_ (scope : Scope.t) ((class_ : Syntax.Ir.qualified), argument) : Ir.constraint_ option
    =
  let argument = ty scope Quantified argument in
  let span = Span.merge class_.span argument.span in
  Option.map
    (fun (found : class_) : Ir.constraint_ -> { class_ = found.global; argument; span })
    (Lookup.find scope classes class_)

let context scope = List.filter_map (constraint_ scope)

let scheme scope (q : Syntax.Ir.qualified_type) : Ir.scheme =
  let context = context scope q.context in
  let t = ty scope Quantified q.ty in
  let span = match q.context with [] -> t.span | (c, _) :: _ -> Span.merge c.span t.span in
  { context; ty = t; span }
