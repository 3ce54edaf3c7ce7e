(* Open addressing with linear probing: a key is stored in its own slot or, if that is taken, in the
   next free one. At most half of the slots are occupied. Values are stored as [Some], so that a
   lookup does not allocate. *)
type 'a t = {
  mutable keys : int array;
  mutable values : 'a option array;  (** [None] in free slots *)
  mutable length : int;
  mutable bits : int;  (** the table has 2^bits slots, or none before the first key *)
}

let fewest_bits = 3
let most_bits_at_first = 8

let rec bits_for n bits =
  if bits >= most_bits_at_first || 1 lsl bits >= n then bits else bits_for n (bits + 1)

let create n = { keys = [||]; values = [||]; length = 0; bits = bits_for n fewest_bits }

(* Multiplies by 2^62 divided by the golden ratio, which scatters consecutive numbers (Knuth, The
   Art of Computer Programming 3, section 6.4). *)
let own_place t key = (key * 0x278DDE6E5FD29F05) lsr (Sys.int_size - t.bits)

(* The slot that contains the key, or the free slot in which to insert it. *)
let rec place t key i =
  match t.values.(i) with
  | Some _ when t.keys.(i) <> key -> place t key ((i + 1) land (Array.length t.keys - 1))
  | Some _ | None -> i

let find_opt t key = if t.length = 0 then None else t.values.(place t key (own_place t key))
let find t key = match find_opt t key with Some value -> value | None -> raise Not_found
let mem t key = match find_opt t key with Some _ -> true | None -> false

let put t key binding =
  let i = place t key (own_place t key) in
  if Option.is_none t.values.(i) then t.length <- t.length + 1;
  t.keys.(i) <- key;
  t.values.(i) <- binding

let make_room t =
  let keys = t.keys and values = t.values in
  if Array.length keys > 0 then t.bits <- t.bits + 2;
  t.keys <- Array.make (1 lsl t.bits) 0;
  t.values <- Array.make (1 lsl t.bits) None;
  t.length <- 0;
  for i = 0 to Array.length keys - 1 do
    match values.(i) with Some _ as binding -> put t keys.(i) binding | None -> ()
  done

let replace t key value =
  if 2 * t.length >= Array.length t.keys then make_room t;
  put t key (Some value)

let take_out t i =
  t.values.(i) <- None;
  t.length <- t.length - 1

let remove t key =
  if mem t key then (
    let next i = (i + 1) land (Array.length t.keys - 1) in
    (* The removed key may have displaced the keys that follow it, so reinsert them. *)
    let rec put_again i =
      match t.values.(i) with
      | None -> ()
      | binding ->
          take_out t i;
          put t t.keys.(i) binding;
          put_again (next i)
    in
    let i = place t key (own_place t key) in
    take_out t i;
    put_again (next i))

let reset t =
  t.keys <- [||];
  t.values <- [||];
  t.length <- 0

let length t = t.length
let copy t = { t with keys = Array.copy t.keys; values = Array.copy t.values }

let fold f t start =
  let result = ref start in
  Array.iteri
    (fun i -> function Some value -> result := f t.keys.(i) value !result | None -> ())
    t.values;
  !result
