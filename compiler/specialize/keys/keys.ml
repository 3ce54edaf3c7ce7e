module Steps = Hashtbl.Make (struct
  type t = int * int

  let equal (a, b) (c, d) = Int.equal a c && Int.equal b d
  let hash (a, b) = ((a * 65_599) + b) land max_int
end)

type t = { steps : int Steps.t; texts : int Basis.String_table.t }

let create () = { steps = Steps.create 1024; texts = Basis.String_table.create 16 }
let empty = 0

(* Adding a vertex takes as much time as several steps, and the vertex stays in memory until the
   end. *)
let steps_of_vertex = 4

(* The sequences form a trie whose vertices are the keys. *)
let add t key number =
  Basis.Work.step ();
  match Steps.find_opt t.steps (key, number) with
  | Some next -> next
  | None ->
      Basis.Work.steps steps_of_vertex;
      let next = Steps.length t.steps + 1 in
      Steps.add t.steps (key, number) next;
      next

let text t text =
  match Basis.String_table.find_opt t.texts text with
  | Some number -> number
  | None ->
      let number = Basis.String_table.length t.texts in
      Basis.String_table.add t.texts text number;
      number
