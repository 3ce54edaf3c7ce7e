let tree ~file text : Syntax.Ir.program option =
  let is_it (shown, prepared, _) = String.equal shown file && String.equal prepared text in
  match List.find_opt is_it Trees.all with
  | Some (_, _, tree) -> Some (Marshal.from_string tree 0)
  | None -> None
