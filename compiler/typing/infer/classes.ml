open Basis
open Context

(* A class constraint reduced to a variable. A constraint on a type reduces to constraints on its
   variables, for the same class or for others. *)
type atom = { class_ : Ir.class_; of_ : variable }
and variable = Quantified of Ir.variable * Type.t | Open

exception Lacking of Instance_fact.lack

(* [compared]: for each data type, which of its type parameters must be comparable for its values to
   be comparable. *)
type search = { ctx : Context.t; compared : (Ir.Global.t, bool list) Hashtbl.t }

let open_representation r =
  match Type.representation r with
  | Rigid_representation r -> Some r.variable
  | Int | Float | Flexible_representation _ -> None

(* Replaces an undetermined representation with its default. *)
let decided t =
  match t with
  | Type.Number (r, u) -> (
      match Type.representation r with
      | Flexible_representation _ -> Type.Number (Float, u)
      | (Int | Float | Rigid_representation _) as r -> Type.Number (r, u))
  | t -> t

let rec atoms search ~through class_ found t =
  Work.step ();
  match (Type.expand t, class_) with
  | Flexible _, _ -> { class_; of_ = Open } :: found
  | (Rigid r as t), _ -> { class_; of_ = Quantified (r.variable, t) } :: found
  | Erroneous, _ -> found
  | t, (Ir.Eq | Ir.Ord) -> structural search ~through class_ found t
  | t, Ir.Declared name -> by_instance search ~through name found t

and structural search ~through class_ found t =
  let lacking culprit = raise_notrace (Lacking { lacking = class_; culprit; through }) in
  match Type.expand t with
  | Number _ | Bool -> found
  | Tuple elements -> List.fold_left (atoms search ~through class_) found elements
  | Data { tycon; arguments; _ } ->
      List.fold_left2
        (fun found is_compared argument ->
          if is_compared then atoms search ~through class_ found argument else found)
        found
        (compared search ~through class_ tycon)
        arguments
  | String | Function _ | Signal_function _ | Size _ | Alias _ -> lacking t
  | Flexible _ | Rigid _ | Erroneous -> atoms search ~through class_ found t

and compared search ~through class_ tycon =
  match Hashtbl.find_opt search.compared tycon with
  | Some compared -> compared
  | None when tycon = Environment.array -> [ false; true ] (* the size, the elements *)
  | None ->
      let environment = search.ctx.reader.environment in
      let { Environment.parameters; definition } = Environment.type_ environment tycon in
      let constructors =
        match definition with
        | Data data -> data.constructors
        | Alias _ | Builtin | Foreign ->
            let arguments = List.map (fun r -> Type.Rigid r) parameters.types in
            let culprit = Type.Data { tycon; units = []; arguments } in
            raise_notrace (Lacking { lacking = class_; culprit; through })
      in
      let field_atoms found (c : Ir.constructor) =
        let constructor = Environment.constructor environment c.constructor in
        let fields, _ = Environment.fields constructor constructor.scheme.body in
        List.fold_left (atoms search ~through class_) found fields
      in
      let found = List.fold_left field_atoms [] constructors in
      let is_compared (r : Type.rigid) =
        List.exists
          (fun atom ->
            match atom.of_ with
            | Quantified (variable, _) -> variable.id = r.variable.id
            | Open -> false)
          found
      in
      let compared = List.map is_compared parameters.types in
      Hashtbl.replace search.compared tycon compared;
      compared

and by_instance search ~through name found t =
  let open_number =
    match t with
    | Type.Number (r, _) ->
        Option.map (fun variable -> (variable, Type.Number (r, Units.one))) (open_representation r)
    | _ -> None
  in
  match (open_number, Head.of_type t) with
  | Some (variable, number), _ ->
      { class_ = Declared name; of_ = Quantified (variable, number) } :: found
  | _, Some (head, arguments) -> (
      match Environment.instance search.ctx.reader.environment name head with
      | None -> raise_notrace (Lacking { lacking = Declared name; culprit = decided t; through })
      | Some instance ->
          let needed found (class_, k) =
            atoms search ~through:(instance :: through) class_ found (List.nth arguments k)
          in
          List.fold_left needed found instance.context)
  | _, None -> found

let entails environment given wanted =
  List.exists
    (fun class_ -> class_ = wanted || List.mem wanted (Environment.superclasses environment class_))
    given

let variable_of t : Ir.variable option =
  match Type.expand t with
  | Rigid r -> Some r.variable
  | Number (r, _) -> open_representation r
  | Flexible _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _ | Size _
  | Alias _ | Erroneous ->
      None

let given_of ctx (variable : Ir.variable) =
  Option.value (Hashtbl.find_opt ctx.given variable.id) ~default:[]

(* Records the first use that requires a constraint, but prefers a use that requires the
   constraint's class directly. *)
let note ctx (variable : Ir.variable) class_ (required : required) =
  let constraint_ = (variable.id, class_) in
  match Hashtbl.find_opt ctx.needs constraint_ with
  | None -> Hashtbl.replace ctx.needs constraint_ required
  | Some earlier ->
      if earlier.class_ <> class_ && required.class_ = class_ then
        Hashtbl.replace ctx.needs constraint_ required

let give ctx (scheme : Type.scheme) =
  List.iter
    (fun (class_, argument) ->
      match variable_of argument with
      | Some variable -> Hashtbl.replace ctx.given variable.id (class_ :: given_of ctx variable)
      | None -> ())
    scheme.context

(* {1 Solving} *)

(* Removes classes that others imply. *)
let smallest environment classes =
  let implied class_ =
    List.exists (fun other -> List.mem class_ (Environment.superclasses environment other)) classes
  in
  List.filter (fun class_ -> not (implied class_)) classes

(* Are these the same type? Numbers are compared by value because {!decided} allocates new ones. *)
let is_same a b =
  match (a, b) with
  | Type.Number (Float, u), Type.Number (Float, u') -> Units.equal u u'
  | _ -> a == b

let solve ctx (generalized : Generalize.t) =
  let environment = ctx.reader.environment in
  let search = { ctx; compared = Hashtbl.create 16 } in
  let own = Hashtbl.create 8 in
  let types = List.map (fun (r : Type.rigid) -> (r.variable, Type.Rigid r)) generalized.types in
  let representations =
    List.map
      (fun (r : Units.rigid) -> (r.variable, Type.Number (Rigid_representation r, Units.one)))
      generalized.representations
  in
  let variables = types @ representations in
  List.iter (fun ((v : Ir.variable), _) -> Hashtbl.replace own v.id []) variables;
  let missing = ref [] and functions = ref [] in
  let answer required { class_; of_ } =
    match of_ with
    | Open -> if errors ctx = 0 then tell_of_instance ctx (Undecided { required; class_ })
    | Quantified (variable, t) -> (
        match Hashtbl.find_opt own variable.id with
        | Some classes ->
            note ctx variable class_ required;
            if not (entails environment classes class_) then
              Hashtbl.replace own variable.id (class_ :: classes)
        | None -> (
            let promises given = entails environment [ given ] class_ in
            match List.filter promises (given_of ctx variable) with
            | [] -> missing := { Instance_fact.required; class_; variable; of_ = t } :: !missing
            | given -> List.iter (fun given -> note ctx variable given required) given))
  in
  List.iter
    (fun (required : required) ->
      match atoms search ~through:[] required.class_ [] required.argument with
      | found -> List.iter (answer required) (List.rev found)
      | exception Lacking lack -> (
          (* If a type is used in place of a robot's type, it is reported once, however many classes
             it lacks. *)
          match Type.expand lack.culprit with
          | culprit
            when Missing_instance.is_no_robot culprit && List.exists (is_same culprit) !functions ->
              ()
          | culprit when Missing_instance.is_no_robot culprit ->
              functions := culprit :: !functions;
              Missing_instance.report ctx required lack
          | _ -> Missing_instance.report ctx required lack))
    (requirements ctx);
  Missing_instance.report_unpromised ctx (List.rev !missing);
  List.concat_map
    (fun ((v : Ir.variable), t) ->
      let classes = smallest environment (List.rev (Hashtbl.find own v.id)) in
      List.map (fun class_ -> (class_, t)) classes)
    variables
