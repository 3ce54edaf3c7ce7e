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

# single NAME: runs NAME.frob once more in single precision, on the input of the last `trace NAME`.
# The engines must agree. Prints the rows that are not near those in double precision.
single() {
    for engine in c interp; do
        frobc trace --real float --engine $engine "$1.frob" --input input.csv --output single.$engine.csv 2>&1 |
            grep -v '^NaN: '
    done
    cmp single.c.csv single.interp.csv
    python3 - compiled.csv single.c.csv <<'END'
import re, sys

number = re.compile(r"(?<![\w.])-?(?:\d[\d.]*(?:e[-+]?\d+)?|inf|nan)(?![\w.])")
for a, b in zip(*(open(name).read().splitlines() for name in sys.argv[1:]), strict=True):
    x, y = (list(map(float, number.findall(row))) for row in (a, b))
    near = all(p == q or p != p and q != q or abs(p - q) <= 1e-3 * max(1, abs(p)) for p, q in zip(x, y))
    if len(x) != len(y) or not near or number.sub("", a) != number.sub("", b):
        print(f"{a} in double precision, but {b}")
END
}
