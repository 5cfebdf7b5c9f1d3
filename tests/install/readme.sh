# The README shows the examples that are built and run by consumer.cmake, to the letter.
source=$1
missing=0
for file in main.cpp contact.cpp CMakeLists.txt; do
  if ! awk -v file="$source/tests/install/example/$file" '
    BEGIN { while ((getline line < file) > 0) example = example line "\n" }
    /^```/ { if (inside && block == example) found = 1; inside = !inside; block = ""; next }
    inside { block = block $0 "\n" }
    END { exit !(found && example != "") }' "$source/README.md"; then
    echo "README.md has no block that is tests/install/example/$file"
    missing=1
  fi
done
for file in $(grep -oE '\]\([^)#:]+\)|src="[^":]+"' "$source/README.md" | sed -E 's/^\]\(//; s/\)$//; s/^src="//; s/"$//'); do
  [ -e "$source/$file" ] || { echo "README.md points to $file, which does not exist"; missing=1; }
done
exit $missing
