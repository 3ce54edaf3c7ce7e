open Basis
open Context

(* What a class needs of a type: the same or other classes of some variables. *)
type atom = { class_ : Ir.class_; of_ : variable }
and variable = Quantified of Ir.variable * Type.t | Open

(* The instances on the way to what is lacking, the last one first. *)
type lack = { lacking : Ir.class_; culprit : Type.t; through : Environment.instance list }

exception Lacking of lack

(* [compared] remembers which type parameters each data type compares. *)
type search = { ctx : Context.t; compared : (Ir.Global.t, bool list) Hashtbl.t }

let open_representation r =
  match Type.representation r with
  | Rigid_representation r -> Some r.variable
  | Int | Float | Flexible_representation _ -> None

(* With the representation that a number will have if nothing decides it. *)
let decided t =
  match t with
  | Type.Number (r, u) -> (
      match Type.representation r with
      | Flexible_representation _ -> Type.Number (Float, u)
      | (Int | Float | Rigid_representation _) as r -> Type.Number (r, u))
  | t -> t

let rec atoms search ~through class_ found t =
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
  match (t, Head.of_type t) with
  | Number (r, _), _ when Option.is_some (open_representation r) ->
      let variable = Option.get (open_representation r) in
      let number = Type.Number (r, Units.one) in
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

(* The first that asks for a constraint is told, unless a later one asks for the
   very class that was promised. *)
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

(* {1 Diagnostics} *)

let explain words required diagnostic =
  match required.because with
  | Some (place, text) -> Diagnostic.label ~at:place (text words) diagnostic
  | None -> diagnostic

let through_instances words { lacking; culprit; through } diagnostic =
  let asks = Show.constraint_ words lacking culprit in
  match through with
  | [] -> diagnostic
  | last :: _ ->
      Diagnostic.label ~at:last.place (Printf.sprintf "this instance asks for `%s`" asks) diagnostic

let is_signal_function t = match Type.expand t with Signal_function _ -> true | _ -> false

let foreign_of ctx t =
  match Type.expand t with
  | Data { tycon; _ }
    when (Environment.type_ ctx.reader.environment tycon).definition = Environment.Foreign ->
      Some tycon
  | _ -> None

let same_foreign ctx a b =
  match (foreign_of ctx a, foreign_of ctx b) with Some a, Some b -> a = b | _, _ -> false

(* What has no capability, and stands where a robot's input or output was meant. *)
let is_no_robot t =
  Environment.is_task t
  ||
  match Type.expand t with
  | Function _ | Signal_function _ | Tuple _ | Number _ | Bool | String -> true
  | Data { tycon; _ } ->
      List.exists
        (fun name -> tycon = Environment.built_in name)
        [ "Event"; "Maybe"; "Either"; "Array" ]
  | Flexible _ | Rigid _ | Size _ | Erroneous | Alias _ -> false

(* The types that have the class. *)
let those_with ctx class_ =
  let name : Head.t -> string option = function Data g -> Some ("`" ^ g.name ^ "`") | _ -> None in
  List.filter_map name (Environment.heads ctx.reader.environment class_)

(* [robot]: its input or output, as it is named. *)
let for_any_robot (class_ : Ir.Global.t) robot =
  let asked =
    match Type.expand robot with
    | Data { tycon; _ } when Filename.check_suffix tycon.name "Output" ->
        Printf.sprintf "(HasOdometry i, %s o)" class_.name
    | _ -> Printf.sprintf "(%s i, DiffDrive o)" class_.name
  in
  Diagnostic.hint
    (Printf.sprintf
       "a program for each robot that has it asks for the class in place of a robot's type: `main \
        :: %s => Program i o`"
       asked)

let is_function t = match Type.expand t with Function _ -> true | _ -> false

let is_with_an_event t =
  match Type.expand t with Tuple [ _; event ] -> Environment.is_event event | _ -> false

let is_pair t = match Type.expand t with Tuple [ _; _ ] -> true | _ -> false

let about_foreign ctx t diagnostic =
  match foreign_of ctx t with
  | None -> diagnostic
  | Some tycon ->
      Diagnostic.hint
        (Printf.sprintf "only C knows what is in a `%s`: import a function that compares two"
           tycon.name)
        diagnostic

(* Of the condition of an assertion, whose author has not heard of classes. *)
let report_no_condition ctx ~at culprit =
  report ctx (fun words ->
      Diagnostic.error ~code:"E0360" ~at "%s is nothing that holds or does not"
        (Show.quoted words culprit)
      |> Diagnostic.hint
           (if Environment.is_event culprit then "`isEvent e` tells whether it occurs now"
            else "what is asserted is a condition, as in `x > 0`, or a `Verdict`"))

(* Of classes and types that the program declares, an instance may just be missing. *)
let is_of_the_program (class_ : Ir.Global.t) culprit =
  (not (List.mem class_.module_ [ "Prelude"; "Capability"; "Trial"; "Display" ]))
  &&
  match Type.expand culprit with
  | Data { tycon; _ } -> not (String.equal tycon.module_ "Prelude")
  | Number _ | Bool -> true
  | _ -> false

let report_lacking ctx required lack =
  match (lack.lacking, lack.through) with
  | Declared class_, [] when class_ = Environment.built_in "Claim" && required.by = "`verdict`" ->
      report_no_condition ctx ~at:required.at lack.culprit
  | _ ->
      let { argument; at; by; _ } : required = required in
      report ctx (fun words ->
          let culprit = Show.quoted words lack.culprit in
          let direct =
            lack.through = []
            && (Type.expand argument == Type.expand lack.culprit
               || same_foreign ctx argument lack.culprit)
          in
          let diagnostic =
            match lack.lacking with
            | Declared _ when Environment.is_task lack.culprit ->
                Diagnostic.error ~code:"E0371" ~at "%s makes no task, but %s is needed here" by
                  culprit
            | Declared _ ->
                Diagnostic.error ~code:"E0360" ~at "there is no instance `%s`"
                  (Show.constraint_ words lack.lacking lack.culprit)
            | (Eq | Ord) as class_ ->
                let what = match class_ with Eq -> "equality" | Ord | Declared _ -> "order" in
                let of_ = if lack.through = [] then Show.quoted words argument else culprit in
                Diagnostic.error ~code:"E0307" ~at "%s has no %s" of_ what
          in
          let diagnostic =
            diagnostic
            |>
            if Environment.is_task lack.culprit then Fun.id
            else fun d ->
              Diagnostic.here (Printf.sprintf "%s needs it" by) d
              |> through_instances words lack |> explain words required
          in
          match lack.lacking with
          | Declared { name = "RobotOutput"; _ } when by = "`roMake`" && is_function lack.culprit ->
              { diagnostic with message = "`roMake` takes one function, and makes an output of it" }
              |> Diagnostic.hint
                   "several commands are put together by a dot: `roMake (setVelTR v omega . \
                    setLight On)`"
          | Declared { name = "RobotOutput"; _ } when is_with_an_event lack.culprit ->
              Diagnostic.hint
                "besides its output it gives the event that ends it, which is lacking here: \
                 `(roMake (…), after 1[s] ())`"
                diagnostic
          | Declared { name = "RobotOutput"; _ } when is_pair lack.culprit ->
              Diagnostic.hint
                "tasks side by side put out both their outputs, of which `mapOutput` makes one; \
                 `timeOut` and `abortWhen` end a task and have its output only"
                diagnostic
          | Declared _ when Environment.is_task lack.culprit ->
              diagnostic
              |> Diagnostic.hint
                   "a task takes time, and no equation runs it: `reactimateTask` does, and in a \
                    `do` one follows another"
          | Declared _ when is_signal_function lack.culprit ->
              Diagnostic.hint "`constant e` is the signal function that always gives `e`" diagnostic
          | (Eq | Ord) when (not direct) && lack.through = [] ->
              Diagnostic.note (Printf.sprintf "it contains %s" culprit) diagnostic
              |> about_foreign ctx lack.culprit
          | (Eq | Ord) when Type.expand lack.culprit = String ->
              Diagnostic.hint
                "a text is a label, and no value; what is one of several has a type of its own: \
                 `data Mode = Go | Stop`"
                diagnostic
          | Eq | Ord -> about_foreign ctx lack.culprit diagnostic
          | Declared { name = "RobotOutput"; _ } when by <> "`roMake`" ->
              let hint = Output_mistake.hint_without_instance lack.culprit in
              Option.fold hint ~none:Fun.id ~some:Diagnostic.hint diagnostic
          | Declared { name = "DiffDrive"; _ } when is_function lack.culprit ->
              Diagnostic.hint
                "`.` composes functions; what one is applied to stands in parentheses: `roMake \
                 (setVelTR v omega)`"
                diagnostic
          | Declared { module_ = "Capability"; _ }
            when lack.through = [] && is_no_robot lack.culprit ->
              Diagnostic.hint
                (Printf.sprintf
                   "this is of a robot's input or output, and what it is given is %s: perhaps two \
                    things stand in the other order"
                   culprit)
                diagnostic
          | Declared class_ when lack.through = [] && is_of_the_program class_ lack.culprit ->
              Diagnostic.hint
                (Printf.sprintf
                   "`instance %s where` gives it one, with its methods in the lines below"
                   (Show.constraint_ words lack.lacking lack.culprit))
                diagnostic
          | Declared class_ -> (
              match those_with ctx class_ with
              | _ :: _ as types when lack.through = [] && List.compare_length_with types 6 <= 0 ->
                  Diagnostic.note
                    (Printf.sprintf "what has `%s`: %s" class_.name (String.concat ", " types))
                    diagnostic
                  |>
                  if String.equal class_.module_ "Capability" then for_any_robot class_ lack.culprit
                  else Fun.id
              | _ -> diagnostic))

let undecided ctx (required : required) class_ =
  report ctx (fun words ->
      Diagnostic.error ~code:"E0308" ~at:required.at "nothing decides the type at which %s is used"
        required.by
      |> Diagnostic.note (Printf.sprintf "it must be a type with `%s`" (Show.class_ class_))
      |> Diagnostic.hint "annotate it, as in `(e :: T)`"
      |> explain words required)

(* {1 Solving} *)

(* Without those that others imply. *)
let smallest environment classes =
  let implied class_ =
    List.exists (fun other -> List.mem class_ (Environment.superclasses environment other)) classes
  in
  List.filter (fun class_ -> not (implied class_)) classes

(* Of numbers, which are made anew, what they are. *)
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
    | Open -> if errors ctx = 0 then undecided ctx required class_
    | Quantified (variable, t) -> (
        match Hashtbl.find_opt own variable.id with
        | Some classes ->
            note ctx variable class_ required;
            if not (entails environment classes class_) then
              Hashtbl.replace own variable.id (class_ :: classes)
        | None -> (
            let promises given = entails environment [ given ] class_ in
            match List.filter promises (given_of ctx variable) with
            | [] -> missing := { Promise_mistake.required; class_; variable; of_ = t } :: !missing
            | given -> List.iter (fun given -> note ctx variable given required) given))
  in
  List.iter
    (fun (required : required) ->
      match atoms search ~through:[] required.class_ [] required.argument with
      | found -> List.iter (answer required) (List.rev found)
      | exception Lacking lack -> (
          (* One that should be something else is one mistake, whatever it lacks. *)
          match Type.expand lack.culprit with
          | culprit when is_no_robot culprit && List.exists (is_same culprit) !functions -> ()
          | culprit when is_no_robot culprit ->
              functions := culprit :: !functions;
              report_lacking ctx required lack
          | _ -> report_lacking ctx required lack))
    (requirements ctx);
  Promise_mistake.report ctx (List.rev !missing);
  List.concat_map
    (fun ((v : Ir.variable), t) ->
      let classes = smallest environment (List.rev (Hashtbl.find own v.id)) in
      List.map (fun class_ -> (class_, t)) classes)
    variables
