# contensou project: values that are known without it. Worked out by hand, from the stored 34-digit tables of the laws, or
# by a bisection here.
#
# Bounds, in units of mu lambda_N: the law promises 4 ulp for uniform and hertz, the projection a part across the normal of
# at most 4 ulp of the largest of force and 1; projecting shortens distances, so an error of the force given counts once.
# Near the ball (forces below 2) that is 4 * 2.2e-16 + 4 * 2.2e-16 + what the force given carries, at most 1e-15: 3e-15.
. "$(dirname "$0")/check.sh"
tables=$(dirname "$0")/../../reference_data/laws

# projects BOUND: in $folder/in, lines l1 l2 ltau p1 p2 ptau inside; the program (options in $options) finds each p within
# BOUND, absolute, inside as given, with a residual of at most 1e-15 of the largest of force and 1, and iterations that are bounded.
projects() {
  cut -d ' ' -f 1-3 "$folder/in" >"$folder/forces"
  # shellcheck disable=SC2086
  run project $options <"$folder/forces"
  succeeds
  checks=$((checks + $(wc -l <"$folder/in")))
  grep -v '^[#p]' "$folder/out" | paste -d ' ' "$folder/in" - | tr '\t' ' ' | awk -v bound="$1" '
    function far(a, b) { a -= b; return !((a < 0 ? -a : a) <= bound) }
    { l = sqrt(($1 / 1e160)^2 + ($2 / 1e160)^2 + ($3 / 1e160)^2) * 1e160; if (l < 1) l = 1 }
    NF != 13 || far($8, $4) || far($9, $5) || far($10, $6) || $11 != $7 || !($13 + 0 <= 1e-15 * l) || $12 > 60 {
      print; bad = 1
    }
    END { exit bad || NR == 0 }' || fail "not where the projection is; columns: force, expected, found"
}

# On the axis and in the plane; inside, to the bit; next to the border; from as far as doubles go.
# Semi-axis: uniform 2/3, hertz 3 pi/16, power:1 4 int_0^1 (1 - r^2) r^2 dr = 8/15.
for pair in 'uniform 0.6666666666666666667' 'hertz 0.5890486225480862322' 'power:1 0.5333333333333333333'; do
  axis=${pair#* }
  options="--pressure ${pair% *}"
  cat >"$folder/in" <<END
0 0 0 0 0 0 1
0.1 -0.2 0.3 0.1 -0.2 0.3 1
0 0 0.5 0 0 0.5 1
-0.6 0.79 0 -0.6 0.79 0 1
5e-324 0 0 5e-324 0 0 1
0 0 1e-300 0 0 1e-300 1
1e-300 -1e-300 1e-300 1e-300 -1e-300 1e-300 1
0 0 2 0 0 $axis 0
0 0 -0.7 0 0 -$axis 0
0 0 1e300 0 0 $axis 0
0 0 -1.7976931348623157e308 0 0 -$axis 0
3 4 0 0.6 0.8 0 0
-3e300 4e300 0 -0.6 0.8 0 0
0 -1.0000000000000002 0 0 -1 0 0
1.7976931348623157e308 0 0 1 0 0 0
1e300 0 1e-300 1 0 0 0
1e-300 0 1e300 0 0 $axis 0
1e300 0 1 1 0 0 0
END
  projects 3e-13 # what power:1 promises, 1e-13, and rounding; uniform and hertz do better: below
done

# u = 1, where the border's normal is (1, 1): the force (xi, eta) + d (1, 1) has its projection at (xi, eta), turned about
# the axis to (3, 4)/5 and back. Uniform: xi = 8/(3 pi), eta = 8/(9 pi). Hertz: xi = 9 pi/32, eta = 9 pi/128.
normal_1_1() { # PRESSURE XI ETA
  options="--pressure $1"
  awk -v x="$2" -v y="$3" 'BEGIN {
    for (i = 0; i < 4; i++) {
      d = substr("0.0010.0300.5001.000", 5 * i + 1, 5) + 0
      printf "%.17g 0 %.17g %.17g 0 %.17g 0\n", x + d, y + d, x, y
      printf "0 %.17g %.17g 0 %.17g %.17g 0\n", -x - d, y + d, -x, y
      printf "%.17g %.17g %.17g %.17g %.17g %.17g 0\n", 0.6 * (x + d), -0.8 * (x + d), -y - d, 0.6 * x, -0.8 * x, -y
    }
    for (i = 0; i < 3; i++) { # from far away only the direction counts
      far = substr("1e1201e2001e300", 5 * i + 1, 5)
      print far, 0, far, x, 0, y, 0
    }
  }' >"$folder/in"
  projects 3e-15
}
normal_1_1 uniform 0.8488263631567751241 0.2829421210522583747
normal_1_1 hertz 0.8835729338221293483 0.2208932334555323371

# Every row of the stored tables is a point of the border with its normal (u, 1): from any distance along the normal it is
# the projection. The forces are rounded, by 2^-53 each for reading, normal (3), distance, sum, turning (2): 1e-15.
for pressure in uniform hertz power:1 power:-0.5 power:20; do
  options="--pressure $pressure"
  table=$tables/$(echo "$pressure" | tr : _).tsv
  case $pressure in power:*) bound=1.1e-13 ;; *) bound=3e-15 ;; esac # power laws promise 1e-13
  for distance in 1e-6 0.01 1; do
    awk -F '\t' -v d="$distance" '
      /^[#u]/ { next }
      $1 == "inf" { t = 1; s = 0 }
      $1 != "inf" && $1 + 0 > 1 { w = 1 / $1; s = w / sqrt(1 + w * w); t = 1 / sqrt(1 + w * w) }
      $1 != "inf" && $1 + 0 <= 1 { s = 1 / sqrt(1 + $1 * $1); t = $1 / sqrt(1 + $1 * $1) }
      {
        printf "%.17g %.17g %.17g ", 0.6 * ($3 + d * t), 0.8 * ($3 + d * t), -($4 + d * s)
        printf "%.17g %.17g %.17g 0\n", 0.6 * $3, 0.8 * $3, -$4
      }' "$table" >"$folder/in"
    check "182 rows expected" [ "$(wc -l <"$folder/in")" -ge 182 ]
    projects $bound
  done
done

# A little inside that border (1e-9 along the normal) the force itself comes back.
for pressure in uniform hertz; do
  options="--pressure $pressure"
  awk -F '\t' '/^[#u]/ || $1 == "inf" || $1 + 0 > 1 { next } {
    r = 1e-9 / sqrt(1 + $1 * $1)
    t = $3 - r * $1
    if (t >= 0) printf "%.17g 0 %.17g %.17g 0 %.17g 1\n", t, $4 - r, t, $4 - r
  }' "$tables/$pressure.tsv" >"$folder/in"
  check "rows expected" [ "$(wc -l <"$folder/in")" -ge 80 ]
  projects 0
done

# The ellipsoid with semi-axes a = 1 and b: x = a^2 t/(a^2 + k), y = b^2 s/(b^2 + k) with k from (x/a)^2 + (y/b)^2 = 1,
# by bisection. k is found to 2e-16 of its size, and x and y move by less than k's relative error.
for pair in 'uniform 0.66666666666666667' 'hertz 0.58904862254808623'; do
  options="--pressure ${pair% *} --model ellipsoid"
  awk -v b="${pair#* }" 'BEGIN {
    srand(2003)
    for (i = 0; i < 300; i++) {
      p1 = 4 * rand() - 2; p2 = 4 * rand() - 2; p3 = 4 * rand() - 2
      if (i % 3 == 0) { p1 *= 0.4; p2 *= 0.4; p3 *= 0.4 }
      t = sqrt(p1 * p1 + p2 * p2); s = p3 < 0 ? -p3 : p3
      if (t * t + s * s / (b * b) <= 1) { printf "%.17g %.17g %.17g %.17g %.17g %.17g 1\n", p1, p2, p3, p1, p2, p3; continue }
      low = 0; high = t + s
      for (j = 0; j < 100; j++) {
        k = (low + high) / 2
        x = t / (1 + k); y = b * s / (b * b + k)
        if (x * x + y * y > 1) low = k; else high = k
      }
      x = 1 / (1 + k); y = b * b / (b * b + k)
      printf "%.17g %.17g %.17g %.17g %.17g %.17g 0\n", p1, p2, p3, x * p1, x * p2, y * p3
    }
  }' >"$folder/in"
  projects 5e-15
done

# Disk x interval, and the disk alone (no torque at all): each part by itself, rounded once or twice.
options='--pressure uniform --model decoupled'
cat >"$folder/in" <<END
3 4 5 0.6 0.8 0.6666666666666666667 0
0.3 -0.4 -5 0.3 -0.4 -0.6666666666666666667 0
-6e200 8e200 0.5 -0.6 0.8 0.5 0
0.5 0.5 0.6 0.5 0.5 0.6 1
END
projects 5e-16
options='--pressure hertz --model disk'
cat >"$folder/in" <<END
3 4 5 0.6 0.8 0 0
0.3 -0.4 -5 0.3 -0.4 0 0
0.3 -0.4 0 0.3 -0.4 0 1
END
projects 5e-16

# The symmetries of the ball hold to the last digit: signs, and the two tangential components exchanged.
awk 'BEGIN { srand(7); for (i = 0; i < 200; i++) printf "%.17g %.17g %.17g\n", 3 * rand(), 3 * rand(), 3 * rand() }' \
  >"$folder/forces"
cells='!/^[#p]/'
for model in exact series corrected ellipsoid decoupled table:64; do
  run project --pressure hertz --model "$model" <"$folder/forces"
  succeeds
  awk "$cells"'{ print $2, $1, $3, $4, $5, $6 }' "$folder/out" >"$folder/expected"
  awk '{ print "-" $2, $1, "-" $3 }' "$folder/forces" >"$folder/turned"
  run project --pressure hertz --model "$model" <"$folder/turned"
  succeeds
  awk "$cells"'{ $1 = substr($1, 1, 1) == "-" ? substr($1, 2) : $1; $3 = substr($3, 1, 1) == "-" ? substr($3, 2) : $3
    print $1, $2, $3, $4, $5, $6 }' "$folder/out" >"$folder/found"
  check "model $model: not symmetric" cmp -s "$folder/expected" "$folder/found"
done

# Projected again, a force stays where it is, to rounding.
for pressure in uniform hertz; do
  options="--pressure $pressure"
  run project --pressure "$pressure" <"$folder/forces"
  grep -v '^[#p]' "$folder/out" | cut -f 1-3 >"$folder/points"
  run project --pressure "$pressure" <"$folder/points"
  succeeds
  check "not idempotent" [ "$(grep -v '^[#p]' "$folder/out" | cut -f 1-3 | paste "$folder/points" - | awk '
    function far(a, b) { a -= b; return a > 1e-15 || a < -1e-15 }
    far($1, $4) || far($2, $5) || far($3, $6) { bad++ } END { print bad + 0 }')" -eq 0 ]
done

finish
