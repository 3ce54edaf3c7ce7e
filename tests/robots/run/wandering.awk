# Adds two lines to the summary of a run, from its recording: the longest time that the
# robot, by its odometry, stayed within half a metre of a place, and the number of
# squares of one metre that it visited.
BEGIN { FS = "," }
NR == 2 { x = $2; y = $3; since = $1 }
NR > 1 {
  if (($2 - x) ^ 2 + ($3 - y) ^ 2 > 0.25) { x = $2; y = $3; since = $1 }
  if ($1 - since > longest) longest = $1 - since
  square = int($2 + 1000) " " int($3 + 1000)
  if (!(square in been)) { been[square] = 1; squares++ }
}
END {
  print "longest stay: " longest " s"
  print "squares: " squares
}
