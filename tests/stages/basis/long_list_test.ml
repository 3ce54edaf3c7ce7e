(* Tests maps over long lists against the standard library's [List]. *)

open Basis

let lists = QCheck.(list_of_size (Gen.oneof [ Gen.int_bound 10; Gen.int_range 990 3000 ]) small_int)

let like_the_standard_one (list, k) =
  let f x = if x mod 10 = k then x + 1 else x in
  List.map f list = Long_list.map f list && List.map f list = Long_list.map_sharing f list

(* The elements are boxed, so that physical equality shows whether an element was copied. *)
let shares (list, k) =
  let list = List.map (fun x -> ref x) list in
  let f x = if !x = k then ref k else x in
  let is_changed = List.exists (fun x -> !x = k) list in
  Long_list.map_sharing f list != list = is_changed

let in_two (list, k) =
  let before, after = Long_list.split_at k list in
  before @ after = list && List.length before = min k (List.length list)

let very_long () =
  let list = List.init 1_000_000 Fun.id in
  Alcotest.(check bool) "stays" true (Long_list.map_sharing Fun.id list == list);
  Alcotest.(check int) "is mapped" 1_000_000 (List.length (Long_list.map_sharing succ list))

let () =
  let case name test =
    Alcotest.test_case name `Quick (fun () ->
        QCheck.Test.check_exn ~rand:(Random.State.make [| 1 |])
          (QCheck.Test.make ~name ~count:300 QCheck.(pair lists (int_bound 10)) test))
  in
  Alcotest.run "Basis.Long_list"
    [
      ( "long_list",
        [
          case "as the standard library's" like_the_standard_one;
          case "the same list if nothing changes" shares;
          case "in two" in_two;
          Alcotest.test_case "a million elements" `Quick very_long;
        ] );
    ]
