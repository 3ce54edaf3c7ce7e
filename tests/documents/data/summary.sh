#!/bin/sh
# summary.sh FROBC DATA EXPECTED: runs the wall follower on recorded sonar readings.
#
# DATA is sensor_readings_24.data of the UCI set "Wall-Following Robot Navigation Data". It has a
# header, then 9 rows a second with the distances that 24 sonars measured, numbered clockwise from
# the front and 15 degrees apart, and the robot's movement. The robot drove clockwise around a room,
# so the wall is on its left: sonar 19. The distance ahead is the smallest of sonars 24, 1 and 2.
#
# Prints a summary of the commands. Without the data, which is not part of the project, it says so
# and prints EXPECTED.
set -eu
frobc=$1 data=$2 expected=$3
if [ ! -r "$data" ]; then
    echo skipped >&2
    cat "$expected"
    exit
fi
awk -F, '
    function min(a, b) { return a < b ? a : b }
    NR == 1 { print "time,in.1,in.2"; next }
    { printf "%.9f,%s,%s\n", (NR - 2) / 9, min($1, min($2, $24)), $19 }' "$data" >open_loop.csv
"$frobc" trace open_loop.frob --input open_loop.csv --output commands.csv
awk -F, '
    NR == 1 { for (i = 2; i <= NF; i++) name[i] = $i; next }
    {
        rows++
        for (i = 2; i <= NF; i++) {
            sum[i] += $i
            if (rows == 1 || $i < least[i]) least[i] = $i
            if (rows == 1 || $i > most[i]) most[i] = $i
        }
    }
    END {
        print rows " rows"
        for (i = 2; i <= NF; i++)
            printf "%s: mean %.4f, from %.4f to %.4f\n", name[i], sum[i] / rows, least[i], most[i]
    }' commands.csv
