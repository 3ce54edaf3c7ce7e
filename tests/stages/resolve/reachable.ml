(* Tests which library definitions a program keeps. The library has this additional module. *)

let extra =
  ( "stdlib/Extra.frob",
    {|
class Doubled a where
    doubled :: a -> a
    doubled x = byDefault x

data Side = L | R

instance Doubled Side where
    doubled x = byInstance x

byDefault x = x
byInstance x = x
kept = 3
used = through
through = 1
unused = alsoUnused
alsoUnused = 2

even', odd' :: Int -> SF Int Bool
even' n = proc x -> odd' n x
odd' n = proc x -> even' n x

inWhere, inGuard, inProc, inCase, inTask :: Float
inWhere = 1
inGuard = 1
inProc = 1
inCase = 1
inTask = 1
|}
  )

let kept text =
  match Support.load [ ("main.frob", "import Extra\n" ^ text); extra ] with
  | _, None -> Alcotest.fail "the program has mistakes"
  | _, Some program ->
      let keep : Resolve.Ir.Global.t list = [ { module_ = "Extra"; name = "kept" } ] in
      let reached = Resolve.Reachable.program ~keep program in
      Resolve.Lint.program reached;
      let name (b : Resolve.Ir.binding) =
        match b.name with
        | Top ({ module_ = "Extra"; name }, _) -> Some name
        | Top _ | Inner _ | Destructure _ -> None
      in
      List.concat_map
        (fun (g : Resolve.Ir.binding_group) -> List.filter_map name g.bindings)
        reached.groups
      |> List.sort String.compare

(* Definitions that every program keeps. *)
let always = [ "byDefault"; "byInstance"; "kept" ]

let check point text expected =
  Alcotest.test_case point `Quick (fun () ->
      Alcotest.(check (list string))
        point
        (List.sort String.compare (always @ expected))
        (kept text))

let all =
  [
    check "instances and defaults stay, and what is to be kept" "main = proc x -> x + 1.0\n" [];
    check "what the program mentions, through others too" "f = used\n" [ "through"; "used" ];
    check "the program's own definitions count whether or not they are run"
      "main = proc x -> x + 1.0\nf = unused\n" [ "alsoUnused"; "unused" ];
    check "a circle stays whole" "f = even' 1\n" [ "even'"; "odd'" ];
    check "wherever it is mentioned"
      {|
f x
    | inGuard > x = y
    | otherwise   = case x of
        z -> inCase
  where y = inWhere

g = proc x -> y where
    y = inProc + x

h = do
    x <- return inTask
    return x
|}
      [ "inCase"; "inGuard"; "inProc"; "inTask"; "inWhere" ];
  ]

let () = Alcotest.run "reachable" [ ("reachable", all) ]
