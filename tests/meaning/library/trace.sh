# trace NAME: runs the compiled program NAME.frob on the rows from standard input; the interpreter
# must produce the same output.
trace() {
    cat >input.csv
    frobc trace --lint --engine interp "$1.frob" --input input.csv --output interpreted.csv
    frobc trace "$1.frob" --input input.csv --output compiled.csv
    cmp compiled.csv interpreted.csv
    cat compiled.csv
}

# rows HEADER: converts each line from standard input to a row, one second apart, under this header.
rows() {
    awk -v header="$1" 'BEGIN { print "time," header } { print NR - 1 "," $0 }'
}

# cells: removes the times and the header from a trace.
cells() {
    sed 1d | cut -d, -f2-
}

# rounded: rounds cells to nine significant digits, for values that the C library computes.
rounded() {
    awk -F, -v OFS=, '{
        for (i = 1; i <= NF; i++) if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) $i = sprintf("%.9g", $i + 0)
        print
    }'
}
