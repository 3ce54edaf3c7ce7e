# Writes a program of one shape, as large as n: awk -v shape=NAME -v n=N -f shapes.awk
BEGIN {
    if (shape == "ifs") {
        printf "main :: SF Int Int\nmain = proc x -> "
        for (i = 0; i < n; i++) printf "if x == %d then %d else ", i, i + 1
        print "x * 7"
    } else if (shape == "lets") {
        printf "main :: SF Int Int\nmain = proc x -> let a0 = x in "
        for (i = 1; i < n; i++) printf "let a%d = a%d + 1 in ", i, i - 1
        printf "a%d\n", n - 1
    } else if (shape == "maybes") {
        printf "f q = case q of\n    "
        for (i = 0; i < n; i++) printf "Just ("
        printf "p"
        for (i = 0; i < n; i++) printf ")"
        printf " -> p\n    _ -> 2\nmain :: SF Int Int\nmain = proc x -> f ("
        for (i = 0; i < n; i++) printf "Just ("
        printf "x"
        for (i = 0; i < n; i++) printf ")"
        print ")"
    } else if (shape == "equations") {
        print "main :: SF Int Int\nmain = proc x -> y" n " where"
        for (i = n; i > 0; i--) printf "    y%d = y%d + x * %d\n", i, i - 1, i
        print "    y0 = x"
    } else if (shape == "delays") {
        print "main :: SF Int Int\nmain = proc x -> y" n " where\n    y0 = x"
        for (i = 1; i <= n; i++) printf "    y%d = delay %d y%d\n", i, i, i - 1
    } else if (shape == "instances") {
        print "class Area a where\n    area :: a -> Float\n"
        for (i = 0; i < n; i++)
            printf "data S%d = S%d Float\ninstance Area S%d where\n    area (S%d x) = x * %d\n\n", i, i, i, i, i + 1
        print "main :: SF Float Float\nmain = proc x -> x0 where"
        for (i = 0; i < n; i++) printf "    x%d = area (S%d x) + %s\n", i, i, (i + 1 < n ? "x" (i + 1) : "x")
    } else if (shape == "tuples") {
        printf "swap :: (a, b) -> (b, a)\nswap (a, b) = (b, a)\n\nmain :: SF Int Int\nmain = proc x -> f ("
        for (i = 0; i < n; i++) printf "(x + %d, ", i
        printf "x"
        for (i = 0; i < n; i++) printf ")"
        printf ") where\n    f p = case p of "
        for (i = 0; i < n; i++) printf "(a%d, ", i
        printf "b"
        for (i = 0; i < n; i++) printf ")"
        printf " -> b"
        for (i = 0; i < n; i++) printf " + a%d", i
        print ""
    } else if (shape == "modes") {
        print "main :: SF Float Float\nmain = mode0\n"
        for (i = 0; i < n; i++)
            printf "mode%d :: SF Float Float\nmode%d = switch (proc x -> (integral (x / 1[s]) + %d, edge (x > %d))) mode%d'\nmode%d' :: () -> SF Float Float\nmode%d' _ = mode%d\n\n", \
                i, i, i, i, i, i, i, (i + 1) % n
    } else if (shape == "nodes") {
        print "import Control\nmain :: SF Float Float\nmain = proc x -> y" n " where\n    y0 = x"
        for (i = 0; i < n; i++) printf "    y%d = f%d y%d\n", i + 1, i, i
        for (i = 0; i < n; i++)
            printf "\nf%d :: SF Float Float\nf%d = proc x -> a + integral (x * %d / 1[s]) where\n    a = delay 0 (a + x)\n", i, i, i
    } else {
        print "no shape " shape > "/dev/stderr"
        exit 2
    }
}
