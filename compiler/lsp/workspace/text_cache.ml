type 'a t = (string, string * 'a) Hashtbl.t

let create () = Hashtbl.create 32

let find t ~path text compute =
  match Hashtbl.find_opt t path with
  | Some (of_text, value) when String.equal of_text text -> value
  | before ->
      let value = compute (Option.map snd before) in
      Hashtbl.replace t path (text, value);
      value
