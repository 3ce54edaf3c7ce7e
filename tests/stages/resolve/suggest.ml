let check point name candidates expected =
  Alcotest.test_case point `Quick (fun () ->
      Alcotest.(check (option string)) point expected (Basis.Suggest.closest name candidates))

let () =
  Alcotest.run "suggest"
    [
      ( "closest",
        [
          check "a missing letter" "velocty" [ "velocity"; "place" ] (Some "velocity");
          check "two letters swapped count once" "sni" [ "sin"; "tan" ] (Some "sin");
          check "capitals are nearest" "frontsonar" [ "frontSonars"; "frontSonar" ]
            (Some "frontSonar");
          check "alphabetical among equals" "fog" [ "fox"; "dog" ] (Some "dog");
          check "nothing far away" "wall" [ "robot"; "sonar" ] None;
          check "not the name itself" "speed" [ "speed" ] None;
          check "a single letter suggests nothing" "x" [ "y"; "z" ] None;
          check "a single letter in its other case" "w" [ "W"; "J" ] (Some "W");
          check "no candidates" "speed" [] None;
          check "long names may differ more" "integralFrm" [ "integralFrom"; "integral" ]
            (Some "integralFrom");
        ] );
    ]
