let ending = ".frob"
let mark = ".test"

let path program =
  Filename.chop_suffix_opt program ~suffix:ending |> Option.value ~default:program |> fun stem ->
  stem ^ mark ^ ending

let program file =
  match Filename.chop_suffix_opt ~suffix:(mark ^ ending) file with
  | Some stem when Filename.basename stem <> "" && not (String.ends_with ~suffix:"/" stem) ->
      Some (stem ^ ending)
  | Some _ | None -> None

let program_or_self file = Option.value (program file) ~default:file
let module_ name = name ^ mark
let is_module_of name ~main = String.equal name main || String.equal (module_ name) main
