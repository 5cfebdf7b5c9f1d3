# What the library may include: itself, the C++ standard library, Eigen and Boost, and in one file the TOML parser (MIT).
# GSL is under the GPL and stays in the programs around it.
source=$1
others=$(grep -rnE '^ *# *include' "$source/lib" |
  grep -vE '# *include +("contensou/|<contensou/|<(Eigen|boost)/|<[a-z_]+>)|/scene/document\.cpp:[0-9]+:# *include <toml\+\+/' || true)
if [ -n "$others" ]; then
  echo "the library includes something else:"
  echo "$others"
  exit 1
fi
if grep -rniE '<gsl|GSL::' "$source/lib" "$source/cli"; then
  echo "GSL has no place here"
  exit 1
fi
[ "$(grep -rlE '^ *# *include' "$source/lib" | wc -l)" -gt 10 ] || { echo "no library found in $source"; exit 1; }
