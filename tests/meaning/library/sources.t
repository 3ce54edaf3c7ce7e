Waves and noise, compared with independent computations: waves with awk, random bits with the shell,
which has 64 bits.

  $ . ./trace.sh
  $ printf '0\n0.25\n0.25\n1.25\n2\n3.125\n5\n7.5\n10\n1000000.25\n' | awk 'BEGIN { print "time,in" } { print $1 ",0" }' > times.csv

  $ cat > waves.frob << FROB
  > import Sources
  > main :: SF Float (Float, Float, Float, Float, Float, Float)
  > main = proc x -> (fraction (turnsAt 0.5[Hz] x), sine 0.5[Hz] x, sine (-0.5[Hz]) x, squareWave 0.5[Hz] x, chirp 0[Hz] 0.5[Hz] 4[s] x, chirp 1[Hz] 0.125[Hz] 0[s] x)
  > FROB
  $ trace waves < times.csv | cells | awk -F, -v OFS=, '{ for (i = 1; i <= NF; i++) $i = sprintf("%.6f", $i + 0); print }' | sed 's/-0.000000/0.000000/g' > found
  $ awk -F, 'NR == 1 { next }
  >   { t = $1; p = atan2(0, -1); turns = t / 2; turned = turns - int(turns)
  >     swept = t < 4 ? t * t / 16 : 1 + (t - 4) / 2
  >     printf "%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", turned, sin(p * t), -sin(p * t), turned < 0.5 ? 1 : -1,
  >       sin(2 * p * (swept - int(swept))), sin(2 * p * (t / 8 - int(t / 8))) }' times.csv | sed 's/-0.000000/0.000000/g' | diff - found

Random bits, and values computed from them; a seed may be any number.

  $ cat > noise.frob << FROB
  > import Sources
  > main :: SF Int (Int, Int, Float)
  > main = proc n -> (nextSeed n, randomBits n, uniform n)
  > FROB
  $ printf '%s\n' 0 1 2 -1 2147483647 -2147483648 -1640531527 | rows in | trace noise | cells > found
  $ cat found
  -1640531527,0,0
  -1640531526,1364076727,0.31759881973266602
  -1640531525,821347078,0.1912347674369812
  -1640531528,-2114883783,0.50759023427963257
  506952120,-104067416,0.97576987743377686
  506952121,1832674720,0.42670279741287231
  1013904242,-1832243442,0.57339757680892944
  $ for n in 0 1 2 -1 2147483647 -2147483648 -1640531527; do
  >   m=4294967295 s=$((n & 4294967295))
  >   a=$(( ((s ^ (s >> 16)) * 2246822507) & m ))
  >   b=$(( ((a ^ (a >> 13)) * 3266489909) & m ))
  >   z=$(( b ^ (b >> 16) ))
  >   echo "$(( (((s + 2654435769) & m) ^ 2147483648) - 2147483648 )),$(( (z ^ 2147483648) - 2147483648 )),$(( z >> 8 ))"
  > done | awk -F, -v OFS=, '{ $3 = sprintf("%.17g", $3 / 16777216); print }' | diff - found

Noise continues from number to number, and uses two for a normally distributed one; single precision
uses the same numbers, as far as it has bits.

  $ cat > signals.frob << FROB
  > import Sources
  > main :: SF Float (Float, Float, Float, Float)
  > main = proc x -> (uniformNoise 7 x, whiteNoise 7 x, colouredNoise 0.5[s] 7 x, colouredNoise 0[s] 7 x)
  > FROB
  $ cat > by_hand.frob << FROB
  > import Sources
  > main :: SF Int (Float, Float)
  > main = proc n -> (uniform n, normal 0.75 (uniform n))
  > FROB
  $ trace signals < times.csv | cells | rounded | tee double
  0.137064159,-0.517535939,-0.517535939,-0.517535939
  0.45108223,-3.35061144,-2.97783887,-3.35061144
  0.998101294,-0.140285633,-2.97783887,-0.140285633
  0.552324831,-0.0735351317,-0.475865265,-0.0735351317
  0.445999205,-0.0334465376,-0.138783198,-0.0334465376
  0.270601034,-0.108711166,-0.122733285,-0.108711166
  0.674866617,1.65987601,1.65653051,1.65987601
  0.257810593,-0.29038798,-0.279219774,-0.29038798
  0.297694445,-0.481600418,-0.483470854,-0.481600418
  0.25633353,-1.12182857,-1.12182857,-1.12182857
  $ frobc trace --real float signals.frob --input times.csv > float
  $ frobc trace --real float --engine interp signals.frob --input times.csv | cmp - float
  $ cells < float | cut -d, -f1 | awk '{ printf "%.7g\n", $1 }' > single
  $ cut -d, -f1 double | awk '{ printf "%.7g\n", $1 }' | diff - single
  $ echo 1640531527 | rows in | trace by_hand | cells | rounded
  0.213861048,0.374851878

White noise is normally distributed, and independent of earlier values; coloured noise is normally
distributed too, and its correlation decays with its time constant.

  $ cat > many.frob << FROB
  > import Sources
  > main :: SF Float (Float, Float)
  > main = proc x -> (whiteNoise 1 x, colouredNoise 0.05[s] 2 x)
  > FROB
  $ awk 'BEGIN { print "time,in"; for (i = 0; i < 50000; i++) printf "%.2f,0\n", i / 100 }' > many.csv
  $ frobc trace many.frob --input many.csv | cells | awk -F, '
  >   { for (i = 1; i <= 2; i++) { sum[i] += $i; square[i] += $i * $i; next_[i] += before[i] * $i; before[i] = $i; far[i] += ($i > 2 || $i < -2) } }
  >   END { for (i = 1; i <= 2; i++) printf "%.1f %.1f %.1f %.2f\n", sum[i] / NR + 1, square[i] / NR, next_[i] / NR + 1, far[i] / NR }'
  1.0 1.0 1.0 0.05
  1.0 1.0 1.8 0.04
