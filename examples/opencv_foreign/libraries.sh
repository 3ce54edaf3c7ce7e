# The options of frobc for the libraries of OpenCV that camshift.cc needs; nothing, and status 1,
# where they are not installed.
for library in core imgproc video; do
  path=$(gcc -print-file-name=libopencv_$library.so)
  [ -e "$path" ] || exit 1
  echo "--with $path"
done
