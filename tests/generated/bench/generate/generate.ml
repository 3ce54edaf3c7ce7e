(* Writes a Frob program of about the given number of lines. It consists of blocks such as
   programmers write (data types, records, functions with case and guards, signal functions with
   feedback), joined ten at a time into larger signal functions, and so on up to main. *)

(* # is replaced by the number of the block. *)
let template =
  {|
data Gait# = Idle# | Walk# Float | Turn# { rate# :: Float, left# :: Bool }

data Body# = Body# { position :: Float[m], speed :: Float[m/s], gait :: Gait# }

-- | Keep y within x on both sides.
bound# :: Float[u] -> Float[u] -> Float[u]
bound# x y = max (-x) (min x y)

gain# :: Gait# -> Float -> Float
gain# gait x = case gait of
    Idle#             -> 0
    Walk# g | g > 100 -> 0.25 * x
             | g > 1   -> g * x
    Walk# _           -> x
    Turn# { rate# = r, left# = l } -> if l then r * x else -(r * x)

choose# :: Float -> Bool -> Gait#
choose# x stop
    | stop      = Idle#
    | x > 2     = Walk# (x - 1)
    | otherwise = Turn# { rate# = sin x, left# = x < 0 }

body# :: Float -> SF (Float[m], Float[m/s]) Body#
body# k = proc (target, limit) -> Body# { position = x, speed = v, gait = g } where
    err  = target - delay 0 x
    v    = bound# limit (k * err / 1[s])
    x    = integral v
    g    = choose# (k * v / 1[m/s]) (abs err < 1[mm])

unit# :: SF Float Float
unit# = proc x -> y where
    b      = body# #.5 (x * 1[m], 0.4[m/s])
    drift  = b.position / 1[m] - x
    change = derivative drift * 1[s]
    y      = gain# b.gait (drift + 0.1 * change) + (let z = x * x in z / (1 + z))
|}

let block k = print_string (String.concat (string_of_int k) (String.split_on_char '#' template))
let lines_of_block = List.length (String.split_on_char '\n' template) - 1

(* Defines [whole], which runs [count] signal functions called [name], from number [first] on,
   one after the other. *)
let join whole name first count =
  Printf.printf "\n%s :: SF Float Float\n%s = proc x0 -> x%d where\n" whole whole count;
  for i = 1 to count do
    Printf.printf "    x%d = %s%d (x%d + 0.%d * x0)\n" i name (first + i - 1) (i - 1) (i mod 10)
  done

let rec levels level name count =
  if count <= 10 then join "main" name 0 count
  else
    let whole = Printf.sprintf "level%dof" level in
    let groups = (count + 9) / 10 in
    for i = 0 to groups - 1 do
      join (Printf.sprintf "%s%d" whole i) name (10 * i) (min 10 (count - (10 * i)))
    done;
    levels (level + 1) whole groups

let () =
  let lines = int_of_string Sys.argv.(1) in
  (* joining ten blocks takes about 15 lines *)
  let blocks = max 1 (10 * lines / ((10 * lines_of_block) + 15)) in
  Printf.printf "-- A generated program of about %d lines.\n" lines;
  for k = 0 to blocks - 1 do
    block k
  done;
  levels 1 "unit" blocks
