# Prints dune rules that compare the parser's output for each program in this folder with the
# expected file next to it.
for program in *.frob; do
    name=${program%.frob}
    cat <<END
(rule
 (action
  (with-stdout-to
   $name.out.now
   (run ../parse_file.exe %{dep:$program}))))

(rule
 (alias runtest)
 (action
  (diff $name.out $name.out.now)))

END
done
