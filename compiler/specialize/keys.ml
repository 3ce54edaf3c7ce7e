module Steps = Hashtbl.Make (struct
  type t = int * int

  let equal (a, b) (c, d) = Int.equal a c && Int.equal b d
  let hash (a, b) = ((a * 65_599) + b) land max_int
end)

type t = { steps : int Steps.t; texts : (string, int) Hashtbl.t }

let create () = { steps = Steps.create 1024; texts = Hashtbl.create 16 }
let empty = 0

(* A trie of all sequences: its vertices are the keys. *)
let add t key number =
  match Steps.find_opt t.steps (key, number) with
  | Some next -> next
  | None ->
      let next = Steps.length t.steps + 1 in
      Steps.add t.steps (key, number) next;
      next

let text t text =
  match Hashtbl.find_opt t.texts text with
  | Some number -> number
  | None ->
      let number = Hashtbl.length t.texts in
      Hashtbl.add t.texts text number;
      number
