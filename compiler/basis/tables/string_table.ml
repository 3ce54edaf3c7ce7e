let hash text =
  let h = ref 0 in
  for i = 0 to String.length text - 1 do
    h := (!h * 65_599) + Char.code (String.unsafe_get text i)
  done;
  !h land max_int

include Hashtbl.Make (struct
  include String

  let hash = hash
end)
