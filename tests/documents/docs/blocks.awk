# The blocks of Frob code in Markdown files, each to a file of its own; prints
# "KIND FILE" for each.
#
#   ```frob            a module, complete but for what a comment right above it
#                      gives, hidden from readers:  <!-- frob ... -->
#   ```frob later      of a version to come, so this one says that it is not for it
#   ```frob title="…"  a file that the page's sessions use: tests/documents/pages tries it
#
# Imports come first in a module, so those of the comment and of the block go
# in front.
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
