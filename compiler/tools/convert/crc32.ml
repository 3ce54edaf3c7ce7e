(* Lookup table for the bit-reversed polynomial. *)
let table =
  lazy
    (Array.init 256 (fun n ->
         let step c = if c land 1 = 1 then 0xedb88320 lxor (c lsr 1) else c lsr 1 in
         step (step (step (step (step (step (step (step n)))))))))

let update crc text =
  let table = Lazy.force table and c = ref (crc lxor 0xffffffff) in
  for i = 0 to String.length text - 1 do
    c :=
      Array.unsafe_get table (!c lxor Char.code (String.unsafe_get text i) land 0xff) lxor (!c lsr 8)
  done;
  !c lxor 0xffffffff
