include Hashtbl.Make (struct
  type t = Ir.Global.t

  (* Hashes only the name, because modules rarely declare the same name. *)
  let hash (x : t) = Basis.String_table.hash x.name
  let equal (a : t) (b : t) = String.equal a.name b.name && String.equal a.module_ b.module_
end)
