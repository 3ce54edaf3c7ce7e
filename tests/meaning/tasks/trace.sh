# trace NAME: the program NAME.frob on the rows from standard input, compiled;
# interpreted it must give the same.
trace() {
    cat >input.csv
    frobc trace --lint --engine interp "$1.frob" --input input.csv --output interpreted.csv
    frobc trace --lint "$1.frob" --input input.csv --output compiled.csv
    cmp compiled.csv interpreted.csv
    cat compiled.csv
}

# rows HEADER: a row for each line from standard input, half a second apart, with
# the header for the cells in front of it.
rows() {
    awk -v header="$1" 'BEGIN { print "time," header } { print (NR - 1) / 2 "," $0 }'
}

# without_lines: a message or table without the numbers of the prelude's lines.
without_lines() {
    awk '/::: stdlib/ { library = 1 }
        library { sub(/^ *[0-9]+ \|/, "    |") }
        { gsub(/Prelude\.frob:[0-9]+(:[0-9]+)?/, "Prelude.frob"); print }'
}
