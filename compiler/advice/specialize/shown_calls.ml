open Basis

let label calls diagnostic =
  let rec labelled diagnostic shown = function
    | (name, at) :: others when List.length shown < 5 ->
        if List.mem at shown then labelled diagnostic shown others
        else
          let text = Printf.sprintf "`%s` is called here" name in
          labelled (Diagnostic.label ~at "%s" text diagnostic) (at :: shown) others
    | [] | _ :: _ -> diagnostic
  in
  labelled diagnostic [] calls
