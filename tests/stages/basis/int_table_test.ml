(* Tests that Basis.Int_table behaves like the standard library's hash tables. *)

open Basis

(* Operations on a table, for comparison with the standard library's. *)
type action = Replace of int * int | Remove of int | Reset

let action =
  let open QCheck.Gen in
  (* keys close together, keys far apart, and negative keys *)
  let key =
    oneof
      [ int_range (-8) 40; map (fun k -> k lsl 20) (int_range (-8) 8); oneofl [ min_int; max_int ] ]
  in
  frequency
    [
      (20, map2 (fun k v -> Replace (k, v)) key small_nat);
      (10, map (fun k -> Remove k) key);
      (1, return Reset);
    ]

let show = function
  | Replace (k, v) -> Printf.sprintf "replace %d %d" k v
  | Remove k -> Printf.sprintf "remove %d" k
  | Reset -> "reset"

let actions =
  QCheck.make
    ~print:QCheck.Print.(list show)
    ~shrink:(fun l -> QCheck.Shrink.list l)
    QCheck.Gen.(list_size (int_range 0 300) action)

let perform table judge action =
  match action with
  | Replace (k, v) ->
      Int_table.replace table k v;
      Hashtbl.replace judge k v
  | Remove k ->
      Int_table.remove table k;
      Hashtbl.remove judge k
  | Reset ->
      Int_table.reset table;
      Hashtbl.reset judge

let sorted fold table = List.sort compare (fold (fun k v all -> (k, v) :: all) table [])

let same table judge =
  Int_table.length table = Hashtbl.length judge
  && sorted Int_table.fold table = sorted Hashtbl.fold judge
  && List.for_all
       (fun k ->
         Int_table.find_opt table k = Hashtbl.find_opt judge k
         && Int_table.mem table k = Hashtbl.mem judge k)
       (List.init 60 (fun k -> k - 10))

let like_the_standard_one actions =
  let table = Int_table.create 16 and judge = Hashtbl.create 16 in
  List.for_all
    (fun action ->
      perform table judge action;
      same table judge)
    actions

let a_copy_is_its_own (actions, more) =
  let table = Int_table.create 1 and judge = Hashtbl.create 1 in
  List.iter (perform table judge) actions;
  let copy = Int_table.copy table and other = Hashtbl.copy judge in
  List.iter (perform copy other) more;
  same table judge && same copy other

let finds () =
  let table = Int_table.create 0 in
  Alcotest.check_raises "nothing" Not_found (fun () -> ignore (Int_table.find table 1));
  Int_table.replace table 1 "one";
  Alcotest.(check string) "something" "one" (Int_table.find table 1)

let property name test () = QCheck.Test.check_exn ~rand:(Random.State.make [| 1 |]) (test name)
let alone name = QCheck.Test.make ~name ~count:300 actions like_the_standard_one
let copied name = QCheck.Test.make ~name ~count:300 (QCheck.pair actions actions) a_copy_is_its_own

let () =
  let case name test = Alcotest.test_case name `Quick (property name test) in
  Alcotest.run "Basis.Int_table"
    [
      ( "int_table",
        [
          Alcotest.test_case "find" `Quick finds;
          case "as the standard library's" alone;
          case "a copy is its own" copied;
        ] );
    ]
