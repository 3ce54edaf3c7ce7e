# Applies a fault of the list, by its number, to a copy of the tree:
#
#   awk -v number=N -v tree=DIR -f apply.awk list
#
# changes the file below DIR and prints its name, a tab and the fault's name. With number=0 it
# changes nothing and reports whether each fault can be applied; with count=1 it only prints their
# number. The text to change must occur in the file exactly once; where it has spaces, the file may
# have other spaces or line breaks. A text may continue on lines that are indented or begin with {.

# Returns a regular expression for the text with any spacing.
function pattern(text) {
    gsub(/[][\\.^$*+?(){}|\/]/, "[&]", text)
    gsub(/\[\\\]/, "[\\\\]", text)
    gsub(/\[\^\]/, "\\^", text)
    gsub(/[ \n]+/, "[ \n]+", text)
    return text
}

function finish(    text, line, at, rest) {
    if (count || !seen || (number && seen != number)) return
    while ((getline line < (tree "/" file)) > 0) text = text line "\n"
    close(tree "/" file)
    at = match(text, pattern(from))
    rest = substr(text, at + RLENGTH)
    if (at == 0 || match(rest, pattern(from)) > 0) {
        printf "FAIL %s: the text of `%s` stands there %s\n", file, name, at == 0 ? "no longer" : "more than once" > "/dev/stderr"
        failed = 1
    } else if (number) {
        printf "%s%s%s", substr(text, 1, at - 1), to, rest > (tree "/" file)
        print file "\t" name
    }
}
/^#/ { next }
/^mutant / { finish(); seen++; name = substr($0, 8); next }
/^file / { file = substr($0, 6); next }
/^from / { part = "from"; from = substr($0, 6); next }
/^to   / { part = "to"; to = substr($0, 6); next }
/^(  |[{])/ { if (part == "from") from = from "\n" $0; else to = to "\n" $0; next }
END {
    finish()
    if (number > seen) {
        print "FAIL there is no fault " number ", only " seen > "/dev/stderr"
        failed = 1
    }
    if (count) print seen
    else if (!number && !failed) print "ok   " seen " faults for `make mutants` can be made"
    exit failed
}
