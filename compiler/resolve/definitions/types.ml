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

(* `s^2` for `s2`, if `s` is a unit. *)
let power_without_caret (scope : Scope.t) (name : Syntax.Ir.name) =
  let text = name.text in
  let last = String.length text - 1 in
  if last < 1 || text.[last] < '2' || text.[last] > '9' then None
  else
    let stem = String.sub text 0 last in
    if Option.is_some (Scope.look scope units { name with text = stem }) then
      Some (Printf.sprintf "%s^%c" stem text.[last])
    else None

let unknown (name : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0208" ~at:name.span "unknown unit `%s`" name.text

let with_power (name : Syntax.Ir.name) power d =
  Diagnostic.hint (Printf.sprintf "write the power with `^`: `%s`" power) d
  |> Diagnostic.write name.span power

let explained (scope : Scope.t) (name : Syntax.Ir.name) =
  let is_unit text = Scope.is_known scope units text in
  Other_unit.explain ~is_unit ~text:scope.text name.span name.text

let unknown_unit (scope : Scope.t) (name : Syntax.Ir.name) =
  match (power_without_caret scope name, explained scope name) with
  | Some power, _ -> unknown name |> with_power name power |> Context.emit scope.context
  | None, Some explain -> unknown name |> explain |> Context.emit scope.context
  | None, None when name.text = "F" ->
      unknown name
      |> Diagnostic.hint "write `A s/V` for a farad, and use kelvin, `K`, for a temperature"
      |> Context.emit scope.context
  | None, None -> ignore (Lookup.find scope units { qualifier = None; name; span = name.span })

let factor (scope : Scope.t) ~variable (name, power) =
  match Scope.look scope units name with
  | Some entry -> Some (Ir.Declared entry.global, power)
  | None when may_be_variable name.text ->
      variable name;
      Some (Ir.Unit_variable name.text, power)
  | None ->
      unknown_unit scope name;
      None

let unit_with scope ~variable (u : Syntax.Ir.unit_) : Ir.unit_ =
  { factors = List.filter_map (factor scope ~variable) (factors u); span = u.span }

let concrete_unit (scope : Scope.t) u =
  let variable (name : Syntax.Ir.name) =
    unknown name
    |> (match Unit_word.symbol name.text with
       | Some symbol ->
           fun d ->
             Diagnostic.hint
               (match Name_in_text.unit_of_literal ~text:scope.text name.span with
               | Some (digits, before, after) when before <> "" || after <> "" ->
                   Printf.sprintf "the unit is `%s`: write `%s[%s%s%s]`" symbol digits before symbol
                     after
               | Some _ | None -> Printf.sprintf "the unit is `%s`" symbol)
               d
             |> Diagnostic.write name.span symbol
       | None when explained scope name <> None -> Option.get (explained scope name)
       | None when power_without_caret scope name <> None ->
           fun d -> with_power name (Option.get (power_without_caret scope name)) d
       | None -> Diagnostic.note "a unit variable is only allowed in a type")
    |> Context.emit scope.context
  in
  unit_with scope ~variable u

let parameter_missing (scope : Scope.t) owner kind (name : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0221" ~at:name.span "%s variable `%s` is not a parameter of `%s`" kind
    name.text owner
  |> Diagnostic.hint
       (if String.equal kind "unit" then
          Printf.sprintf "declare it in brackets after the name: `%s[%s]`" owner name.text
        else Printf.sprintf "declare it after the name: `%s %s`" owner name.text)
  |> Context.emit scope.context

let unit_ (scope : Scope.t) variables u =
  let variable (name : Syntax.Ir.name) =
    match variables with
    | Parameters { units; owner; _ } when not (String_set.mem name.text units) ->
        parameter_missing scope owner "unit" name
    | Parameters _ | Quantified -> ()
  in
  unit_with scope ~variable u

(* Types *)

let counted n noun = Printf.sprintf "%d %s%s" n noun (if n = 1 then "" else "s")

let check_arity (scope : Scope.t) at (tycon : tycon) ~units ~types =
  let wrong ~expected ~found noun =
    let diagnostic =
      Diagnostic.error ~code:"E0216" ~at "type `%s` takes %s, not %d" tycon.global.name
        (counted expected noun) found
    in
    (if String.equal tycon.global.name "Array" && is_builtin tycon then
       Diagnostic.hint
         (if found > 2 then "write a matrix as an array of arrays: `Array 2 (Array 3 Float)`"
          else "write the size and the type of the elements, as in `Array 4 Float`")
         diagnostic
     else if String.equal tycon.global.name "SF" && is_builtin tycon && found > 2 then
       Diagnostic.hint "combine several inputs in a tuple, as in `SF (a, b) c`" diagnostic
     else if String.equal tycon.global.name "SF" && is_builtin tycon then
       Diagnostic.hint
         "write the types of the input and the output, as in `SF Float Bool`; use `()` for no input"
         diagnostic
     else if String.equal tycon.global.name "Task" && is_builtin tycon then
       Diagnostic.hint
         "write the types of the input, the output and the result, as in `Task i o ()`; use `()` \
          for no result"
         diagnostic
     else if String.equal tycon.global.name "Program" && is_builtin tycon then
       Diagnostic.hint
         "write the types of the robot's input and output, as in `Program RobotInput RobotOutput`"
         diagnostic
     else if String.equal noun "unit argument" && expected = 1 && found = 0 then
       let name = tycon.global.name in
       Diagnostic.label ~at:tycon.span "declared here" diagnostic
       |> Diagnostic.hint
            (Printf.sprintf "use `%s[1]` for plain numbers, or with their unit, as in `%s[m]`" name
               name)
     else if is_builtin tycon then diagnostic
     else
       Diagnostic.label ~at:tycon.span "declared here" diagnostic
       |>
       if found < expected && String.equal noun "type argument" then
         Diagnostic.hint
           (Printf.sprintf "give it %s, as in `%s`" (counted expected noun)
              (String.concat " " (tycon.global.name :: List.init expected (fun _ -> "Float"))))
       else Fun.id)
    |> Context.emit scope.context
  in
  let units_right = units = tycon.unit_arity || (units = 0 && tycon.units_optional) in
  let types_right = types = tycon.type_arity in
  if not units_right then wrong ~expected:tycon.unit_arity ~found:units "unit argument";
  if not types_right then wrong ~expected:tycon.type_arity ~found:types "type argument";
  units_right && types_right

let rec ty (scope : Scope.t) variables (t : Syntax.Ir.ty) : Ir.ty =
  Context.nested scope.context t.span ~otherwise:(missing t.span) (fun () ->
      { (missing t.span) with desc = desc scope variables t })

and desc scope variables (t : Syntax.Ir.ty) : Ir.ty_desc =
  match t.desc with
  | Type_variable name ->
      (match variables with
      | Parameters { types; owner; _ } when not (String_set.mem name.text types) ->
          parameter_missing scope owner "type" name
      | Parameters _ | Quantified -> ());
      Type_variable name.text
  | Type { name; units; arguments } -> (
      let units = Long_list.map (unit_ scope variables) (Option.value units ~default:[]) in
      let arguments = Long_list.map (ty scope variables) arguments in
      match Lookup.find scope tycons name with
      | None -> Tuple_type []
      | Some tycon ->
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
      | Parameters { owner; _ } ->
          Diagnostic.error ~code:"E0222" ~at:name.span
            "`%s` can be a Float or an Int, and `%s` has no parameter to choose between them"
            name.text owner
          |> Diagnostic.hint "write `Float[…]` or `Int[…]`, or make the whole type a parameter"
          |> Context.emit scope.context);
      Representation { variable = name.text; unit_ = unit_ scope variables u }
  | Function (a, b) ->
      let a = ty scope variables a in
      Function (a, ty scope variables b)
  | Tuple_type ts -> Tuple_type (Long_list.map (ty scope variables) ts)
  | Size n -> Size n
  | Size_operation _ -> (
      (* after an error, any size will do *)
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
            Diagnostic.error ~code:"E0330" ~at:t.span "`%s` is not a number, but part of a size"
              name.name.text
            |> Diagnostic.hint "define a size as `type N = 25`"
            |> Context.emit scope.context;
          alias.size)
  | Size_operation { operator; left; right } -> (
      match (known_size scope left, known_size scope right) with
      | Some left, Some right -> Some (size_operation operator left right)
      | _ -> None)
  | Type_variable name ->
      Diagnostic.error ~code:"E0330" ~at:t.span
        "`%s` is a variable, but arithmetic on sizes needs known numbers" name.text
      |> Diagnostic.hint
           "use another variable for the result, as in `take :: Array n a -> Array k a`"
      |> Context.emit scope.context;
      None
  | Type _ | Representation _ | Function _ | Tuple_type _ ->
      Diagnostic.error ~code:"E0330" ~at:t.span "this type is part of a size, but not a number"
      |> Diagnostic.hint "define a size as `type N = 25`"
      |> Context.emit scope.context;
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
