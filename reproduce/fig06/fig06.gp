# Figure 6: friction force over v for fixed γ_τ, friction torque over γ_τ for fixed v; uniform pressure.
load style

eval panel("fig06a", 480, 420)
set xrange [-2:2]; set yrange [-1.15:1.15]
set xtics 1; set ytics 0.5
set zeroaxis linestyle 8
set xlabel "{/:Italic v} [m/s]"
set ylabel "−{/:Italic λ_T}/({/:Italic μλ_N})"
set key bottom right Left reverse samplen 2 spacing 1.2 width -1.5 title "{/:Italic γ_τ} [m/s]"
file = data."/fig06a.tsv"
plot data."/fig06a_set.tsv" using "v":"minus_lambda_t" with lines linestyle 3 title "0", \
     file using "v":"0.125" with lines linestyle 11 title "0.125", \
     file using "v":"0.25" with lines linestyle 12 title "0.25", \
     file using "v":"0.5" with lines linestyle 13 title "0.5", \
     file using "v":"1" with lines linestyle 14 title "1"

eval panel("fig06b", 480, 420)
set yrange [-0.78:0.78]
set ytics ("−2/3" -2.0/3, "−1/3" -1.0/3, "0" 0, "1/3" 1.0/3, "2/3" 2.0/3)
set xlabel "{/:Italic γ_τ} [m/s]"
set ylabel "−{/:Italic λ_τ}/({/:Italic μλ_N})"
set key title "{/:Italic v} [m/s]"
file = data."/fig06b.tsv"
plot data."/fig06b_set.tsv" using "gamma_tau":"minus_lambda_tau" with lines linestyle 3 title "0", \
     file using "gamma_tau":"0.125" with lines linestyle 11 title "0.125", \
     file using "gamma_tau":"0.25" with lines linestyle 12 title "0.25", \
     file using "gamma_tau":"0.5" with lines linestyle 13 title "0.5", \
     file using "gamma_tau":"1" with lines linestyle 14 title "1"
