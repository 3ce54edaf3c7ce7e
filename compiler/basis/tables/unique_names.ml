type t = { shown : string Int_table.t; uses : int String_table.t }

let create () = { shown = Int_table.create 16; uses = String_table.create 16 }

let clear t =
  Int_table.reset t.shown;
  String_table.reset t.uses

let find_opt t id = Int_table.find_opt t.shown id

let find t ~id name =
  match find_opt t id with
  | Some shown -> shown
  | None ->
      let use = 1 + Option.value (String_table.find_opt t.uses name) ~default:0 in
      String_table.replace t.uses name use;
      let shown = if use = 1 && name <> "" then name else Printf.sprintf "%s_%d" name use in
      Int_table.replace t.shown id shown;
      shown
