(* Tests the parts of the fuzzer on small examples. *)

open Fuzz

let root = "../../.."
let ( / ) = Filename.concat

let tools =
  {
    Engines.library = root / "stdlib";
    runtime = root / "runtime";
    folder = Filename.current_dir_name;
    real = Basis.Real.Double;
    probed = false;
  }

let strings = Alcotest.(list string)

let leaves_out_all_it_can () =
  let needed text = String.contains text 'c' && String.contains text 'h' in
  let parts = [ "a"; "b"; "c"; "d"; "e"; "f"; "g"; "h"; "i" ] in
  Alcotest.check strings "what is needed" [ "c"; "h" ]
    (Reduction.without_some ~separator:" " parts needed)

let offers_parts_of_a_group () =
  match Reduction.at "x = (f (g y) 0)" 0 with
  | None -> Alcotest.fail "no group is found"
  | Some (place, candidates) ->
      Alcotest.(check int) "the outer one first" 4 place;
      let offered text = Alcotest.(check bool) text true (List.mem text candidates) in
      List.iter offered [ "x = 0"; "x = (g y)"; "x = f" ]

let brackets_need_not_match () =
  Alcotest.(check bool) "none closes" true (Reduction.at "(a [b" 0 = None)

let shape : Interp.Shape.t =
  let constructor name fields = { Interp.Shape.name; fields } in
  Tuple
    [
      Float Double;
      Array (2, Int);
      Data
        {
          is_event = true;
          constructors =
            [ constructor "NoEvent" []; constructor "Event" [ ("", Tuple [ Bool; Float Single ]) ] ];
        };
    ]

let recordings_are_read_as_written () =
  let recording = Input.make (Random.State.make [| 5 |]) Wild shape ~rows:40 in
  let csv = Recording.csv recording in
  match Recording.read shape csv with
  | Ok read -> Alcotest.(check string) "the same" csv (Recording.csv read)
  | Error text -> Alcotest.fail text

let recordings_with_dt_are_read_as_written () =
  List.iter
    (fun precision ->
      let recording = Input.with_dt (Random.State.make [| 5 |]) precision shape ~rows:200 in
      match Recording.read shape (Recording.csv recording) with
      | Error text -> Alcotest.fail text
      | Ok read ->
          Alcotest.(check string) "the same" (Recording.csv recording) (Recording.csv read);
          Alcotest.(check bool) "precision" true (Recording.precision read = precision);
          let same a b =
            Float.equal a b && (Float.is_nan a || Float.sign_bit a = Float.sign_bit b)
          in
          let dts = Recording.seconds recording in
          let check text others = Alcotest.(check bool) text true (List.for_all2 same dts others) in
          check "the same dts" (Recording.seconds read);
          check "of the precision" (List.map (Basis.Real.round precision) dts))
    [ Basis.Real.Double; Single ]

(* Every kind of dt must occur. *)
let steps_of_any_dt () =
  let random = Random.State.make [| 6 |] in
  let dts =
    List.concat
      (List.init 200 (fun _ -> Recording.seconds (Input.with_dt random Double shape ~rows:20)))
  in
  let some text test = Alcotest.(check bool) text true (List.exists test dts) in
  some "NaN" Float.is_nan;
  some "negative" (fun dt -> dt < 0.);
  some "infinite" (fun dt -> dt = Float.infinity);
  some "too long" (fun dt -> dt > 1e9 && dt < Float.infinity);
  some "half a nanosecond" (fun dt -> dt *. 1e9 < 1e6 && Float.rem (dt *. 1e9) 1. = 0.5);
  let nearest dt = Float.round (dt *. 1e9) /. 1e9 in
  some "beside whole nanoseconds" (fun dt ->
      dt > 1e-3 && dt < 1. && Float.succ dt = nearest dt && dt <> nearest dt)

let tables_of_the_file_stay_constant () =
  let c =
    "static const int a[1] = {1};\n\
     struct s {\n\
    \    int x;\n\
     };\n\
     {\n\
    \    static const struct s t = {2};\n\
     }"
  in
  let adapted =
    "static const int a[1] = {1};\n\
     struct s {\n\
     _Alignas(8) int x;\n\
     };\n\
     {\n\
     const struct s t = {2};\n\
     }"
  in
  Alcotest.(check string) "for tcc" adapted (Build.Tcc.adapted c)

(* The type error is the Bool in an addition; the rest of the program is not needed for it. *)
let mistaken =
  {|choose :: Bool -> a -> a -> a
choose c x y = if c then x else y

unused :: SF Float Float
unused = proc x -> delay 0 (integral x / 1[s])

main :: SF (Float, Bool) Float
main = proc (x, b) -> (choose b (x + (if b then True else False)) (unused x))
|}

let shrinks_what_is_rejected () =
  let outcome =
    let file = "mistaken.frob" in
    let channel = open_out file in
    output_string channel mistaken;
    close_out channel;
    match Engines.load tools ~entry:"main" file with
    | Error outcome -> outcome
    | Ok _ -> Alcotest.fail "it should be rejected"
  in
  let small =
    Shrink.program tools [ Tcc ] ~seconds:60. ~first:[]
      { text = mistaken; outcome; recordings = [] }
  in
  let lines = List.filter (fun line -> String.trim line <> "") (Reduction.lines small.text) in
  Alcotest.(check bool) ("small: " ^ small.text) true (List.length lines <= 2);
  match (outcome, small.outcome) with
  | Rejected before, Rejected after ->
      let code text = List.hd (String.split_on_char ':' text) in
      Alcotest.(check string) "for the same reason" (code before) (code after)
  | _, _ -> Alcotest.fail "it should be rejected still"

let sees_what_is_never_generated () =
  let prelude = "primitive sin, cos :: Angle -> Float\n\nnot :: Bool -> Bool\n" in
  let seen = Coverage.create () in
  ignore (Program.make ~seen ~seed:1 ~first:0 ~count:200 () : string);
  Coverage.count_words seen "sin cos";
  let missing = Coverage.missing ~prelude:(prelude ^ "unheardOf :: Int\n") seen in
  Alcotest.(check bool) "unheardOf" true (List.mem "unheardOf" missing);
  Alcotest.(check bool) "sin" false (List.mem "sin" missing)

let programs_depend_on_their_numbers_alone () =
  let text first count = Program.make ~seed:3 ~first ~count () in
  let alone = Reduction.paragraphs (text 7 1) and together = Reduction.paragraphs (text 0 12) in
  let own paragraph = String.starts_with ~prefix:"p7 ::" paragraph in
  Alcotest.check strings "program 7" (List.filter own alone) (List.filter own together)

let () =
  let case (name, test) = Alcotest.test_case name `Quick test in
  Alcotest.run "the judge's tools"
    [
      ( "reduction",
        List.map case
          [
            ("leaves out all it can", leaves_out_all_it_can);
            ("offers parts of a group", offers_parts_of_a_group);
            ("brackets need not match", brackets_need_not_match);
            ("shrinks what is rejected", shrinks_what_is_rejected);
          ] );
      ( "recordings and C",
        List.map case
          [
            ("recordings are read as written", recordings_are_read_as_written);
            ("recordings with dts are read as written", recordings_with_dt_are_read_as_written);
            ("steps of any dt", steps_of_any_dt);
            ("tables of the file stay constant", tables_of_the_file_stay_constant);
          ] );
      ( "generator",
        List.map case
          [
            ("sees what is never generated", sees_what_is_never_generated);
            ("programs depend on their numbers alone", programs_depend_on_their_numbers_alone);
          ] );
    ]
