# Figure 9: inclination of the tippe-top; (b) its nutation from near.
load style

motion = data."/fig09.tsv"; near = data."/fig09_nutation.tsv"; printed = data."/fig09_printed.tsv"
set style line 21 linecolor rgb blue      linewidth 1.2
set style line 22 linecolor rgb vermilion linewidth 1.4
set xlabel "{/:Italic t} [s]"
set ylabel "{/:Italic θ} [rad]"
set ytics ("0" 0, "π/4" pi/4, "π/2" pi/2, "3π/4" 3*pi/4, "π" pi)

# (a) with the times that the paper tells, above
eval panel("fig09a", 860, 470)
set lmargin at screen 0.075; set rmargin at screen 0.985; set bmargin at screen 0.135; set tmargin at screen 0.83
set xrange [0:8]; set yrange [0:3.3]
set xtics 1
set key at 7.9, 0.95 right top spacing 1.2
do for [time in "1.5 1.6 4.0 4.55 4.65 5.4"] { set arrow from time, 0 to time, 3.3 nohead linestyle 8 back }
set label 1 "LG03:" at -0.1, 3.62 right font ",13"
set label 2 "stick\ntouches" at 1.46, 3.72 right font ",13"
set label 3 "upright" at 2.8, 3.47 center font ",13"
set arrow 90 from 1.6, 3.36 to 4.0, 3.36 heads size screen 0.008,20 linestyle 9
set label 4 "body\ntouches" at 4.5, 3.72 right font ",13"
set label 5 "both touch" at 5.025, 3.47 center font ",13"
set arrow 91 from 4.65, 3.36 to 5.4, 3.36 heads size screen 0.008,20 linestyle 9
plot motion using "t":"uniform" with lines linestyle 21 title "uniform pressure", \
     motion using "t":"hertz" with lines linestyle 22 title "Hertz pressure"

# (b)
eval panel("fig09b", 640, 330)
unset arrow; unset label; unset key
set lmargin at screen 0.105; set rmargin at screen 0.975; set bmargin at screen 0.19; set tmargin at screen 0.96
set xrange [0.6:1.0]; set yrange [*:*]
set xtics 0.1; set ytics 0.2; set format y "%.1f"
set label 1 "Hertz" at 0.875, 1.45 right textcolor rgb vermilion
set label 2 "uniform" at 0.9, 1.1 left textcolor rgb blue
plot near using "t":"uniform" with lines linestyle 1, \
     near using "t":"hertz" with lines linestyle 13
