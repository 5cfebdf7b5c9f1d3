# Figure 10: distances of the contacts from the floor; (b) the rocking from near; (c) how its impacts accumulate.
load style

motion = data."/fig10.tsv"; near = data."/fig10_rocking.tsv"; impacts = data."/fig10_impacts.tsv"
set style line 21 linecolor rgb blue      linewidth 1.4
set style line 22 linecolor rgb vermilion linewidth 1.4
mm = 1e3

# (a)
eval panel("fig10a", 860, 430)
set lmargin at screen 0.075; set rmargin at screen 0.985; set bmargin at screen 0.145; set tmargin at screen 0.965
set xlabel "{/:Italic t} [s]"
set ylabel "distance from the floor [mm]"
set xrange [0:8]; set yrange [-0.5:25]
set xtics 1; set ytics 5
set key at 7.9, 24 right top spacing 1.2
plot motion using "t":(mm*column("tip")) with lines linestyle 21 title "stick, {/:Italic g}_{N2}", \
     motion using "t":(mm*column("body")) with lines linestyle 22 title "body, {/:Italic g}_{N1}"

# (b)
eval panel("fig10b", 535, 380)
set lmargin at screen 0.125; set rmargin at screen 0.96; set bmargin at screen 0.165; set tmargin at screen 0.96
set xrange [4.74:4.91]; set yrange [-0.01:0.32]
set xtics 0.05; set ytics 0.1; set format x "%.2f"
set key at 4.908, 0.305
plot near using "t":(mm*column("tip")) with lines linestyle 11 title "stick", \
     near using "t":(mm*column("body")) with lines linestyle 13 title "body"

# (c)
eval panel("fig10c", 535, 380)
set lmargin at screen 0.135; set logscale xy
set xrange [1:1e-5] ; set yrange [1e-7:1]
set format x "10^{%T}"; set format y "10^{%T}"
set xtics 10 autofreq; set ytics 10 autofreq
set xlabel "time until the impacts accumulate [s]"
set ylabel "time until the next impact [s]"
set key at 2e-5, 0.5 right
is(contact, value) = strcol("contact") eq contact ? value : NaN
plot impacts using "until_end":(is("tip", column("until_next"))) with points pointtype 7 pointsize 0.55 linecolor rgb vermilion title "body in the air", \
     impacts using "until_end":(is("body", column("until_next"))) with points pointtype 6 pointsize 0.75 linewidth 1.4 linecolor rgb blue title "stick in the air"
