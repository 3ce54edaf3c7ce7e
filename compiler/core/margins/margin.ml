open Basis
open Ir

let word = "margin "

let column name number =
  let label = Option.value (Resolve.Labels.label name) ~default:name in
  Printf.sprintf "%s%s %d" word label number

let is_column = String.starts_with ~prefix:word

(* {1 Conditions on the past} *)

let past name : Global.t = { module_ = "Past"; name }

(* The functions that take a time argument, and those that do not. *)
let with_time = List.map past [ "within"; "heldFor"; "by"; "respondsWithin" ]
let without = List.map past [ "ever"; "always"; "since" ]
let is_timed g = List.mem g with_time || List.mem g without
let verdict : Global.t = { module_ = "Prelude"; name = "Verdict" }
let fails = 3

(* {1 One assertion} *)

type claim = {
  reading : Reading.t;
  name : string;
  mutable count : int;
  mutable equations : equation list; (* newest first *)
}

let head c env e = Reading.head c.reading ~stop:is_timed env e

let shown c (value : expr) =
  c.count <- c.count + 1;
  let local = Reading.fresh c.reading (column c.name c.count) value.span in
  let equation = { binder = { local; ty = value.ty }; rhs = Pure value; span = value.span } in
  c.equations <- equation :: c.equations;
  c.count

let itself c env e = Formula.Column (shown c (Reading.copy c.reading env e))

(* Does the expression depend only on time and constants? *)
let of_time_alone c env e =
  let is_time = ref false in
  let rec is_other env (e : expr) =
    match head c env e with
    | { env; expr = { desc = Local x; _ } } -> (
        match Reading.run c.reading env x with
        | Some { env; expr } -> (
            match (head c env expr).expr.desc with
            | Primitive (Time, _) ->
                is_time := true;
                false
            | _ -> true)
        | None -> true)
    | { env; expr } -> List.exists (is_other env) (Term.parts expr)
  in
  (not (is_other env e)) && !is_time

let binary p ty result (a : expr) (b : expr) =
  let partial = Function (ty, result) in
  let p = Term.make (Function (ty, partial)) a.span (Primitive (p, [ ty ])) in
  Term.apply (Term.apply p a partial a.span) b result a.span

(* The difference of two numbers. It is 0 if they are equal, because infinity minus infinity would
   be NaN. *)
let difference c env (span : Span.t) (a : expr) (b : expr) =
  let number (e : expr) =
    let e = Reading.copy c.reading env e in
    if e.ty = Int then
      let convert = Term.make (Function (Int, Float)) e.span (Primitive (To_float, [])) in
      Term.apply convert e Float e.span
    else e
  in
  let zero = Term.make Float span (Number Exact.zero) in
  let equal = binary Equal Float Bool (number a) (number b) in
  let less = binary Subtract Float Float (number b) (number a) in
  Formula.Column (shown c { (Term.if_ equal zero less span) with span })

let rec arguments (e : expr) found =
  match e.desc with Apply (f, a) -> arguments f (a :: found) | _ -> (e, found)

let rec formula c env (e : expr) : Formula.t =
  let { Reading.env = inside; expr } = head c env e in
  match expr.desc with
  | Boolean b -> Constant b
  | If (condition, a, b) ->
      let condition = formula c inside condition in
      let a = formula c inside a in
      Formula.choice condition a (formula c inside b)
  | Is_constructor (value, k) -> is c inside value k ~otherwise:(fun () -> itself c env e)
  | Apply ({ desc = Apply ({ desc = Primitive (p, [ ty ]); _ }, a); _ }, b) ->
      comparison c inside e.span p (Reading.ty inside ty) a b ~otherwise:(fun () -> itself c env e)
  | Apply ({ desc = Apply ({ desc = Primitive (And, []); _ }, a); _ }, b) ->
      let a = formula c inside a in
      Formula.and_ a (formula c inside b)
  | Apply ({ desc = Apply ({ desc = Primitive (Or, []); _ }, a); _ }, b) ->
      let a = formula c inside a in
      Formula.or_ a (formula c inside b)
  | Local x -> (
      match instance c inside x with
      | Some (`Timed formula) -> formula
      | Some (`Entered (env, output)) -> formula c env output
      | None -> itself c env e)
  | _ -> itself c env e

and comparison c env span (p : Primitive.t) ty a b ~otherwise =
  let is_number = ty = Float || ty = Int in
  let both_alone = lazy (of_time_alone c env (Term.make ty span (Tuple [ a; b ]))) in
  let at_most a b = difference c env span a b in
  match p with
  | (Less | Less_equal | Greater | Greater_equal) when is_number ->
      if Lazy.force both_alone then otherwise ()
      else if p = Less || p = Less_equal then at_most a b
      else at_most b a
  | (Equal | Not_equal) when is_number ->
      if Lazy.force both_alone then otherwise ()
      else
        let d = at_most a b in
        let equal = Formula.and_ d (Formula.not_ d) in
        if p = Equal then equal else Formula.not_ equal
  | (Equal | Not_equal) when ty = Bool ->
      let a = formula c env a and b = formula c env b in
      let same = Formula.choice a b (Formula.not_ b) in
      if p = Equal then same else Formula.not_ same
  | Equal | Not_equal -> (
      let tagged (e : expr) =
        match (head c env e).expr.desc with
        | Construct { constructor; arguments = []; _ } -> Some constructor
        | _ -> None
      in
      let is value k =
        let same = is c env value k ~otherwise in
        if p = Equal then same else Formula.not_ same
      in
      match (tagged a, tagged b) with
      | _, Some k -> is a k
      | Some k, None -> is b k
      | None, None -> otherwise ())
  | _ -> otherwise ()

(* The condition that the value has this constructor. *)
and is c env value k ~otherwise =
  let { Reading.env; expr } = head c env value in
  let is_last = expr.ty = Data (verdict, []) && k = fails in
  match expr.desc with
  | Construct { constructor; _ } -> Constant (constructor = k)
  | If (condition, a, b) ->
      let condition = formula c env condition in
      let part e = is c env e k ~otherwise:(fun () -> has c env e k) in
      let a = part a in
      Formula.choice condition a (part b)
  | Apply ({ desc = Apply ({ desc = Primitive (Maximum, _); _ }, a); _ }, b) when is_last ->
      let part e = is c env e k ~otherwise:(fun () -> has c env e k) in
      let a = part a in
      Formula.or_ a (part b)
  | Local x -> (
      match instance c env x with
      | Some (`Timed formula) when is_last -> Formula.not_ formula
      | Some (`Entered (env, output)) -> is c env output k ~otherwise:(fun () -> has c env output k)
      | Some (`Timed _) | None -> otherwise ())
  | _ -> otherwise ()

and has c env value k = itself c env (Term.make Bool value.span (Is_constructor (value, k)))

(* The condition computed by the signal function whose instance defines the variable. *)
and instance c env x =
  match (Reading.run c.reading env x, Reading.input c.reading env x) with
  | Some { env = of_function; expr }, Some input -> (
      let found = head c of_function expr in
      match (found.expr.desc, arguments found.expr []) with
      | Proc p, _ -> Some (`Entered (Reading.enter found.env p ~input, p.output))
      | _, ({ desc = Global (g, _); _ }, given) when is_timed g ->
          Option.map (fun f -> `Timed f) (timed c g found.env given input)
      | _ -> None)
  | _ -> None

and timed c (g : Global.t) env given { env = of_input; expr = input } =
  let time =
    match given with [ q ] -> Some (shown c (Reading.copy c.reading env q)) | _ -> None
  in
  let timed conditions : Formula.t = Timed { operator = g.name; time; conditions } in
  if g.name = "since" || g.name = "respondsWithin" then
    match head c of_input input with
    | { env; expr = { desc = Tuple [ a; b ]; _ } } ->
        let a = formula c env a in
        Some (timed [ a; formula c env b ])
    | _ -> None
  else Some (timed [ formula c of_input input ])

(* The condition is that the verdict does not have the constructor [fails]. *)
let of_verdict c env (e : expr) =
  Formula.not_ (is c env e fails ~otherwise:(fun () -> has c env e fails))

(* {1 All assertions} *)

let program (program : program) =
  let reading = Reading.create program in
  let found = Hashtbl.create 16 in
  let claim env (eq : equation) =
    match eq.rhs with
    | Pure e when Resolve.Labels.is_name eq.binder.local.name -> (
        let c = { reading; name = eq.binder.local.name; count = 0; equations = [] } in
        match of_verdict c env e with
        | formula ->
            Hashtbl.replace found eq.binder.local.span formula;
            Reading.added reading @ List.rev c.equations
        | exception Reading.Too_large ->
            ignore (Reading.added reading);
            [])
    | Pure _ | Run _ -> []
  in
  let rec expr (e : expr) =
    let desc = Term.with_parts expr e in
    match desc with
    | Proc p ->
        let added = List.concat_map (fun eq -> claim (Reading.of_proc reading p) eq) p.equations in
        { e with desc = Proc { p with equations = p.equations @ added } }
    | desc -> { e with desc }
  in
  let definition (d : definition) = { d with body = expr d.body } in
  ({ program with definitions = List.map definition program.definitions }, Hashtbl.find_opt found)
