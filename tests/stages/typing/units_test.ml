(* Tests the unification of units on random equations: the properties that a solution must have. *)

module Units = Typing.Units
module Rational = Typing.Rational

(* A unit as exponents of the base units m and s, of a signature's variable, and of the unknowns
   x0, x1, x2. *)
type sample = { m : int; s : int; u : int; xs : int list }

let base name : Typing.Ir.Global.t = { module_ = "Prelude"; name }
let rigid : Units.rigid = { variable = { id = 100; name = "u" }; depth = 1 }
let variables () = List.init 3 (fun id -> Units.fresh ~id ~depth:1)

let build variables { m; s; u; xs } =
  let power unit_ n = Units.power unit_ (Rational.of_int n) in
  List.fold_left2
    (fun product x n -> Units.multiply product (power x n))
    (Units.multiply
       (Units.multiply (power (Units.base (base "m")) m) (power (Units.base (base "s")) s))
       (power (Units.of_rigid rigid) u))
    variables xs

let samples =
  let open QCheck.Gen in
  let exponent = int_range (-3) 3 in
  map
    (fun ((m, s), (u, xs)) -> { m; s; u; xs })
    (pair (pair exponent exponent) (pair exponent (list_size (return 3) exponent)))

let print { m; s; u; xs } =
  Printf.sprintf "m^%d s^%d u^%d x^(%s)" m s u (String.concat "," (List.map string_of_int xs))

let sample = QCheck.make ~print samples
let equation = QCheck.pair sample sample
let system = QCheck.list_of_size (QCheck.Gen.int_range 1 4) equation

let solve variables equations =
  List.for_all (fun (a, b) -> Units.unify (build variables a) (build variables b)) equations

let unifies =
  QCheck.Test.make ~count:1000 ~name:"a solution makes both sides equal" system (fun equations ->
      let variables = variables () in
      (not (solve variables equations))
      || List.for_all (fun (a, b) -> Units.equal (build variables a) (build variables b)) equations)

(* Substitute known values to get equations that hold, so that a solution exists. The solution
   must be at least as general as these values. *)
let most_general =
  QCheck.Test.make ~count:1000 ~name:"a solution is the most general"
    (QCheck.pair
       (QCheck.list_of_size (QCheck.Gen.return 3) sample)
       (QCheck.list_of_size (QCheck.Gen.int_range 1 3) sample))
    (fun (values, lefts) ->
      let closed sample = { sample with xs = [ 0; 0; 0 ] } in
      let values = List.map (fun v -> build (variables ()) (closed v)) values in
      let variables = variables () in
      (* each left side equals its value after the substitution *)
      let solved =
        List.for_all (fun left -> Units.unify (build variables left) (build values left)) lefts
      in
      solved && List.for_all2 (fun x value -> Units.unify x value) variables values)

let idempotent =
  QCheck.Test.make ~count:1000 ~name:"solving again changes nothing" system (fun equations ->
      let variables = variables () in
      if not (solve variables equations) then true
      else
        let show () = List.map (fun x -> Units.flexible_powers (Units.resolve x)) variables in
        let before = show () in
        solve variables equations && show () = before)

let order =
  QCheck.Test.make ~count:1000 ~name:"the order of equations does not matter" system
    (fun equations ->
      Bool.equal (solve (variables ()) equations) (solve (variables ()) (List.rev equations)))

let refused =
  QCheck.Test.make ~count:1000 ~name:"without variables, only equal units unify" equation
    (fun (a, b) ->
      let closed sample = { sample with xs = [ 0; 0; 0 ] } in
      let a = closed a and b = closed b in
      Bool.equal (a = b) (Units.unify (build (variables ()) a) (build (variables ()) b)))

let test_escape () =
  let outer = Units.fresh ~id:1 ~depth:0 in
  Alcotest.(check bool) "an outer variable" false (Units.unify outer (Units.of_rigid rigid));
  Alcotest.(check bool) "still free" true (Units.unify outer (Units.base (base "m")))

let test_principal () =
  let x = Units.fresh ~id:1 ~depth:0 and y = Units.fresh ~id:2 ~depth:0 in
  let product = Units.multiply (Units.multiply x y) (Units.base (base "m")) in
  let fresh () : Units.rigid = { variable = { id = 7; name = "v" }; depth = 0 } in
  ignore (Units.generalize ~fresh product);
  Alcotest.(check string)
    "one variable for a product that occurs as a whole" "v"
    (Typing.Show.unit_ (Units.to_ir product))

let property test =
  let (QCheck2.Test.Test cell) = test in
  Alcotest.test_case (QCheck2.Test.get_name cell) `Quick (fun () ->
      QCheck.Test.check_exn ~rand:(Random.State.make [| 1 |]) test)

let () =
  Alcotest.run "Typing.Units"
    [
      ("properties", List.map property [ unifies; most_general; idempotent; order; refused ]);
      ( "variables",
        [
          Alcotest.test_case "no outer variable depends on a signature's" `Quick test_escape;
          Alcotest.test_case "generalizing gives the simplest form" `Quick test_principal;
        ] );
    ]
