# trace NAME: the program NAME.frob on the rows from standard input, compiled;
# interpreted it must give the same.
trace() {
    cat >input.csv
    frobc trace --lint --engine interp "$1.frob" --input input.csv --output interpreted.csv
    frobc trace "$1.frob" --input input.csv --output compiled.csv
    cmp compiled.csv interpreted.csv
    cat compiled.csv
}

# rows HEADER: a row for each line from standard input, a second apart, with the
# header for the cells in front of it.
rows() {
    awk -v header="$1" 'BEGIN { print "time," header } { print NR - 1 "," $0 }'
}

# cells: a trace without its times and header.
cells() {
    sed 1d | cut -d, -f2-
}

# rounded: cells with nine significant digits, for what the C library computes.
rounded() {
    awk -F, -v OFS=, '{
        for (i = 1; i <= NF; i++) if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) $i = sprintf("%.9g", $i + 0)
        print
    }'
}
