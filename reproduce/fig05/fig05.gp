# Figure 5: friction force and torque; uniform pressure solid, Hertz ("parabolic") pressure dashed.
load style

eval panel("fig05a", 480, 380)
set xrange [0:4]; set yrange [0:1.08]
set xtics 1; set ytics 0.25
set xlabel "{/:Italic u}"
set ylabel "‖{/:Italic λ_T}‖/({/:Italic μλ_N})" offset 2.0, 0
set key bottom right Left reverse samplen 3 spacing 1.3 width -3
plot 1 with lines linestyle 8, \
     data."/fig05a.tsv" using "u":"xi_uniform" with lines linestyle 1 title "uniform", \
     data."/fig05a.tsv" using "u":"xi_hertz" with lines linestyle 2 title "parabolic (Hertz)"

eval panel("fig05b", 480, 380)
set yrange [0:0.76]
set ytics 0.2
set xlabel "1/{/:Italic u}"
set ylabel "|{/:Italic λ_τ}|/({/:Italic μλ_N})"
set label 1 "2/3" at 0.06, 2.0/3 left offset 0,0.55
set label 2 "3π/16" at 0.06, 3*pi/16 left offset 0,0.55
plot 2.0/3 with lines linestyle 8, 3*pi/16 with lines linestyle 8, \
     data."/fig05b.tsv" using "inverse_u":"eta_uniform" with lines linestyle 1 title "uniform", \
     data."/fig05b.tsv" using "inverse_u":"eta_hertz" with lines linestyle 2 title "parabolic (Hertz)"
