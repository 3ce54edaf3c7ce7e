# One fault of the list, by its number, in a copy of the tree:
#
#   awk -v number=N -v tree=DIR -f apply.awk list
#
# changes the file below DIR and prints its name, a tab and the fault's. With
# number=0 it changes nothing and says whether each fault could be made, with
# count=1 only how many there are. The text to change must stand in the file
# exactly once. A text may go on in lines that are indented or begin with {.

function finish(    text, line, at, rest) {
    if (count || !seen || (number && seen != number)) return
    while ((getline line < (tree "/" file)) > 0) text = text line "\n"
    close(tree "/" file)
    at = index(text, from)
    rest = substr(text, at + length(from))
    if (at == 0 || index(rest, from) > 0) {
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
