# trace NAME: runs the compiled program NAME.frob on the rows from standard input; the interpreter
# must produce the same output.
trace() {
    cat >input.csv
    frobc trace --lint --engine interp "$1.frob" --input input.csv --output interpreted.csv
    frobc trace --lint "$1.frob" --input input.csv --output compiled.csv
    cmp compiled.csv interpreted.csv
    cat compiled.csv
}

# rows HEADER: converts each line from standard input to a row, half a second apart, under this
# header.
rows() {
    awk -v header="$1" 'BEGIN { print "time," header } { print (NR - 1) / 2 "," $0 }'
}

# without_lines: removes the prelude's line numbers from a message or table.
without_lines() {
    awk '/::: stdlib/ { library = 1 }
        library { sub(/^ *[0-9]+ \|/, "    |") }
        { gsub(/Prelude\.frob:[0-9]+(:[0-9]+)?/, "Prelude.frob"); print }'
}
