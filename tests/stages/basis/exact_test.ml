open Basis

let decimal text =
  match Exact.of_literal text with Some n -> n | None -> Alcotest.failf "%s is a decimal" text

(* Decimals of the form [digits.digitsE±dd], short and long. *)
let decimals =
  QCheck.Gen.(
    let digits low high = string_size ~gen:numeral (int_range low high) in
    map
      (fun ((whole, fraction), exponent) -> Printf.sprintf "%s.%se%d" whole fraction exponent)
      (pair (pair (digits 1 30) (digits 0 30)) (int_range (-30) 30)))

let numbers = QCheck.make ~print:Fun.id decimals

let rounding =
  QCheck.Test.make ~count:500 ~name:"a decimal is rounded as the C library rounds it" numbers
    (fun text -> Float.equal (Exact.to_float (decimal text)) (float_of_string text))

(* Numbers with an exponent take another path through the reader. *)
let short =
  let digits low high = QCheck.Gen.(string_size ~gen:numeral (int_range low high)) in
  let text = QCheck.Gen.(map2 (fun a b -> a ^ "." ^ b) (digits 1 9) (digits 0 9)) in
  let text = QCheck.Gen.(oneof [ digits 1 18; text ]) in
  QCheck.Test.make ~count:500 ~name:"a short decimal is the same with the exponent 0"
    (QCheck.make ~print:Fun.id text) (fun text ->
      Exact.equal (decimal text) (decimal (text ^ "e0")))

let test_forms () =
  let refused text =
    Alcotest.(check bool) (Printf.sprintf "`%s`" text) true (Exact.of_literal text = None)
  in
  List.iter refused
    [
      ""; "."; ".5"; "1.2.3"; "-1"; "+1"; "1e"; "e1"; "1x"; " 1"; "0x"; "0b2"; "0o8"; "0x1.5"; "1x0";
    ];
  let read value text = Alcotest.(check string) text value (Exact.to_string (decimal text)) in
  List.iter (read "31") [ "0x1F"; "0X1f"; "0o37"; "0b1_1111"; "31"; "3_1"; "3.1e1" ];
  read "340282366920938463463374607431768211455" ("0x" ^ String.make 32 'f')

let field =
  QCheck.Test.make ~count:300 ~name:"dividing undoes multiplying, subtracting undoes adding"
    (QCheck.pair numbers numbers) (fun (a, b) ->
      let a = decimal a and b = decimal b in
      let minus x = Exact.add x (Exact.negate b) in
      Exact.equal (minus (Exact.add a b)) a
      && (Exact.equal b Exact.zero || Exact.equal (Exact.divide (Exact.multiply a b) b) a))

let order =
  QCheck.Test.make ~count:300 ~name:"comparison is the sign of the difference"
    (QCheck.pair numbers numbers) (fun (a, b) ->
      let a = decimal a and b = decimal b in
      let difference = Exact.add a (Exact.negate b) in
      Exact.compare a b = Exact.compare difference Exact.zero
      && Exact.compare (Exact.negate a) (Exact.negate b) = Exact.compare b a)

let test_degrees () =
  let degree = Exact.divide Exact.pi (Exact.of_int 180) in
  Alcotest.(check (float 0.)) "180 degrees" Float.pi Exact.(to_float (multiply degree (of_int 180)));
  Alcotest.(check string)
    "90 over pi" "90"
    Exact.(to_string (divide (multiply (of_int 90) degree) degree))

let property test =
  let (QCheck2.Test.Test cell) = test in
  Alcotest.test_case (QCheck2.Test.get_name cell) `Quick (fun () ->
      QCheck.Test.check_exn ~rand:(Random.State.make [| 1 |]) test)

let () =
  Alcotest.run "Basis.Exact"
    [
      ("properties", List.map property [ rounding; short; field; order ]);
      ("forms", [ Alcotest.test_case "what is no decimal" `Quick test_forms ]);
      ("pi", [ Alcotest.test_case "degrees are exact" `Quick test_degrees ]);
    ]
