# Writes each block of Frob code in Markdown files to a file of its own; prints "KIND
# FILE" for each.
#
#   ```frob            a module; a comment directly above it may add code that is hidden from
#                      readers:  <!-- frob ... -->
#   ```frob later      code for a later version, which this version must reject
#   ```frob title="…"  a file for the page's sessions: tests/documents/pages tests it
#
# Imports come first in a module, so the imports of the comment and of the block are moved
# to the front.
function finish() {
    printf "%s%s", imports, text >file
    close(file)
    print kind, file
    state = "text"
    imports = text = ""
}
FNR == 1 { state = "text"; imports = text = "" }
state == "text" && /^<!-- frob$/ { state = "comment"; next }
state == "comment" && /^-->$/ { state = "text"; next }
state == "text" && /^```frob( later)?$/ {
    state = "block"
    kind = $2 == "" ? "module" : $2
    name = FILENAME
    gsub(/[^A-Za-z0-9]+/, "_", name)
    file = sprintf("%s_line_%d.frob", name, FNR)
    next
}
state == "block" && /^```$/ { finish(); next }
state == "text" && NF > 0 { imports = text = "" }
state != "text" && /^import / { imports = imports $0 "\n"; next }
state != "text" { text = text $0 "\n" }
