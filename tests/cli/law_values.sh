# contensou law: values that are known in closed form, each worked out by hand here and put into decimals with bc.
#
# Bound: every law promises 4 ulp for the uniform and the Hertz pressure, at most 4 * 2^-52 = 8.9e-16; reading the decimals
# below adds half an ulp: 1e-15. Other pressures promise 1e-13.
. "$(dirname "$0")/check.sh"

# Uniform. u = 0: phi = eta = (1/(pi R^2)) int (rho/R) dA = 2/3. u = inf: every element slides alike, phi = xi = 1.
# u = 1: complete elliptic integrals of modulus 1, B = 1, D infinite but times 1 - m = 0, so that
# f = (4/9pi)(3+5)B = 32/(9pi), xi = (4/3pi) 2B = 8/(3pi), eta = (4/9pi)(3-1)B = 8/(9pi), phi = f/sqrt(2).
run law --pressure uniform 0 1 inf
succeeds
row 0 0.6666666666666666667 0 0.6666666666666666667 1e-15
row 1 0.8002811699174276174 0.8488263631567751241 0.2829421210522583747 1e-15
row inf 1 1 0 1e-15

# Hertz, from LG03 (3.14), (3.17), (3.18). u <= 1: f = (3pi/128)(8 + 8u^2 - u^4), xi = (3pi/32) u (4 - u^2),
# eta = (3pi/128)(8 - 8u^2 + 3u^4); u = 0 gives 3pi/16, u = 1 gives xi = 9pi/32, eta = 9pi/128.
# u = 2: arcsin(1/2) = pi/6, hence f = 3pi/16 + 27 sqrt(3)/32, xi = 9 sqrt(3)/16, eta = (3/64)(4pi - 6 sqrt(3)).
run law --pressure hertz 0 0.5 1 2 inf
succeeds
row 0 0.5890486225480862322 0 0.5890486225480862322 1e-15
row 0.5 0.6544602786535989237 0.5522330836388308427 0.4555922940020354452 1e-15
row 1 0.7809755164731503169 0.8835729338221293483 0.2208932334555323371 1e-15
row 2 0.9169964920865288391 0.9742785792574934777 0.1019093329193394934 1e-15
row inf 1 1 0 1e-15

# The paraboloid, n = 1. u = 0: eta = 4 int_0^1 (1 - r^2) r^2 dr = 8/15. u = 1, by Gauss's theorem for 2F1 at 1:
# f = 256/(75pi), xi = 128/(45pi), eta = 128/(225pi); phi = f/sqrt(2).
run law --pressure power:1 0 1 inf
succeeds
row 0 0.5333333333333333333 0 0.5333333333333333333 1e-13
row 1 0.7682699231207305 0.9054147873672268 0.1810829574734454 1e-13
row inf 1 1 0 1e-13

# power:0 and power:0.5 are the uniform and the Hertz pressure.
for pair in 'uniform power:0' 'hertz power:0.5'; do
  run law --pressure "${pair% *}" 0.1 0.9 1 1.1 7
  mv "$folder/out" "$folder/named"
  run law --pressure "${pair#* }" 0.1 0.9 1 1.1 7
  succeeds
  while IFS='	' read -r u phi xi eta; do
    case $u in [0-9]*) row "$u" "$phi" "$xi" "$eta" 1e-13 ;; esac
  done <"$folder/named"
done

# Every model has a finite answer everywhere, and the one for no spin is that of Coulomb: phi = xi = 1, eta = 0 (the
# decoupled and the tanh law keep them too).
for pressure in uniform hertz power:1; do
  for model in exact series series:3 printed ellipsoid decoupled pade pade2 tanh:0.01; do
    [ "$pressure $model" = "power:1 printed" ] && continue # the paper prints no law for it
    run law --pressure "$pressure" --model "$model" 0 1e-3 0.999 1 1.001 1e3 inf
    succeeds
    check "8 lines of table expected" [ "$(grep -vc '^#' "$folder/out")" -eq 8 ]
    check "not finite" [ -z "$(grep -v '^#' "$folder/out" | cut -f 2-4 | grep -i -E 'nan|inf')" ]
  done
done

finish
