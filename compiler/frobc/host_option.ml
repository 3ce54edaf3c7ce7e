open Cmdliner

let flag name ~doc =
  let arguments given = if given then [ "--" ^ name ] else [] in
  let given = Arg.(value & flag & info [ name ] ~doc) in
  Term.(const arguments $ given)

let described kind ?print ?absent name ~docv ~doc =
  let print = Option.value print ~default:(Format.asprintf "%a" (Arg.conv_printer kind)) in
  let arguments values = List.concat_map (fun value -> [ "--" ^ name; print value ]) values in
  (arguments, Arg.info [ name ] ?absent ~docv ~doc)

let one kind ?print ?absent name ~docv ~doc =
  let arguments, description = described kind ?print ?absent name ~docv ~doc in
  let arguments value = arguments (Option.to_list value) in
  Term.(const arguments $ Arg.(value & opt (some kind) None & description))

let many name ~docv ~doc =
  let arguments, description = described Arg.string ~print:Fun.id name ~docv ~doc in
  Term.(const arguments $ Arg.(value & opt_all string [] & description))

let time_span name = one Options.time_span ~print:(Printf.sprintf "%.9f") name

let all terms =
  List.fold_left (fun some more -> Term.(const ( @ ) $ some $ more)) (Term.const []) terms
