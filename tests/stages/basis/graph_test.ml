(* Tests Basis.Graph: components in order of evaluation, and shortest cycles. *)

open Basis

let check_components name expected graph =
  Alcotest.(check (list (list int))) name expected (Graph.components graph)

let order () =
  check_components "what is needed comes first" [ [ 2 ]; [ 1 ]; [ 0 ]; [ 3 ] ]
    [| [ 1 ]; [ 2 ]; []; [ 0 ] |];
  check_components "without edges the order stays" [ [ 0 ]; [ 1 ]; [ 2 ] ] [| []; []; [] |];
  check_components "a cycle is one component"
    [ [ 3 ]; [ 0; 1; 2 ]; [ 4 ] ]
    [| [ 1 ]; [ 2; 3 ]; [ 0 ]; []; [ 1 ] |]

let cyclic () =
  let graph = [| [ 0 ]; []; [ 1 ] |] in
  let cyclic component = Graph.is_cyclic graph component in
  Alcotest.(check (list bool))
    "an edge to itself" [ true; false; false ]
    (List.map cyclic (Graph.components graph))

let shortest () =
  let cycle graph = Graph.shortest_cycle graph (List.init (Array.length graph) Fun.id) in
  Alcotest.(check (list int))
    "the chord is taken" [ 1; 2; 4 ]
    (cycle [| [ 1 ]; [ 2 ]; [ 3; 4 ]; [ 4 ]; [ 0; 1 ] |]);
  Alcotest.(check (list int))
    "from the smallest vertex, along the edges" [ 0; 2; 1 ]
    (cycle [| [ 2 ]; [ 0 ]; [ 1 ] |]);
  Alcotest.(check (list int))
    "an edge to itself is shortest" [ 2 ]
    (cycle [| [ 1 ]; [ 2 ]; [ 2; 0 ] |])

let large () =
  let n = 1_000_000 in
  let ring = Array.init n (fun v -> [ (v + 1) mod n ]) in
  Alcotest.(check int) "one component" 1 (List.length (Graph.components ring));
  let chain = Array.init n (fun v -> if v = 0 then [] else [ v - 1 ]) in
  Alcotest.(check int) "as many as vertices" n (List.length (Graph.components chain));
  let ring = Array.init 100_000 (fun v -> [ (v + 1) mod 100_000 ]) in
  let all = List.init 100_000 Fun.id in
  Alcotest.(check int) "the whole ring" 100_000 (List.length (Graph.shortest_cycle ring all))

(* Compares small random graphs with definitions by reachability. *)
let graph_gen =
  QCheck.Gen.(
    int_range 1 8 >>= fun n ->
    list_repeat n (list_size (int_bound 3) (int_bound (n - 1))) >|= Array.of_list)

let distances graph =
  let n = Array.length graph in
  let far = 1000 in
  let d = Array.make_matrix n n far in
  Array.iteri (fun v -> List.iter (fun w -> d.(v).(w) <- 1)) graph;
  for k = 0 to n - 1 do
    for i = 0 to n - 1 do
      for j = 0 to n - 1 do
        d.(i).(j) <- min d.(i).(j) (d.(i).(k) + d.(k).(j))
      done
    done
  done;
  d

let agrees_with_reachability graph =
  let d = distances graph in
  let components = Graph.components graph in
  let position = Array.make (Array.length graph) 0 in
  List.iteri (fun i -> List.iter (fun v -> position.(v) <- i)) components;
  let reaches v w = v = w || d.(v).(w) < 1000 in
  let ok = ref true in
  Array.iteri
    (fun v _ ->
      Array.iteri
        (fun w _ ->
          let together = reaches v w && reaches w v in
          if together <> (position.(v) = position.(w)) then ok := false;
          if reaches v w && position.(v) < position.(w) then ok := false)
        graph)
    graph;
  List.iter
    (fun component ->
      let shortest = List.fold_left (fun best v -> min best d.(v).(v)) 1000 component in
      if Graph.is_cyclic graph component <> (shortest < 1000) then ok := false;
      if shortest < 1000 then (
        let cycle = Graph.shortest_cycle graph component in
        let next = List.tl cycle @ [ List.hd cycle ] in
        if List.length cycle <> shortest then ok := false;
        if not (List.for_all2 (fun v w -> List.mem w graph.(v)) cycle next) then ok := false))
    components;
  !ok

let random =
  QCheck.Test.make ~count:2000 ~name:"random graphs agree with reachability"
    (QCheck.make
       ~print:(fun g ->
         String.concat "; "
           (Array.to_list (Array.map (fun s -> String.concat "," (List.map string_of_int s)) g)))
       graph_gen)
    agrees_with_reachability

let () =
  Alcotest.run "Basis.Graph"
    [
      ( "graph",
        [
          Alcotest.test_case "components come in order of evaluation" `Quick order;
          Alcotest.test_case "cyclic components" `Quick cyclic;
          Alcotest.test_case "shortest cycle" `Quick shortest;
          Alcotest.test_case "large graphs" `Quick large;
          Alcotest.test_case "random graphs agree with reachability" `Quick (fun () ->
              QCheck.Test.check_exn ~rand:(Random.State.make [| 1 |]) random);
        ] );
    ]
