# Reads gcc's call graph of a C file, with the stack that each function uses
# (-fcallgraph-info=su), and prints the bytes of the longest chain of calls from
# the function ROOT; with LIBRARY=1, the functions called that are not in it.

function text(line, key,    rest) {
    rest = substr(line, index(line, key ": \"") + length(key) + 3)
    return substr(rest, 1, index(rest, "\"") - 1)
}
/^node:/ {
    if (match($0, /[0-9]+ bytes/)) own[text($0, "title")] = substr($0, RSTART, RLENGTH) + 0
    else outside[text($0, "title")] = 1
}
/^edge:/ {
    caller = text($0, "sourcename")
    called[caller, ++count[caller]] = text($0, "targetname")
}
function longest(f,    i, inner, most) {
    if (f in known) return known[f]
    for (i = 1; i <= count[f]; i++) {
        inner = longest(called[f, i])
        if (inner > most) most = inner
    }
    return known[f] = own[f] + most
}
END {
    if (library) for (f in outside) print f
    else print longest(root) + 0
}
