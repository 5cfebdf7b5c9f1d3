# Figure 12: inclination of the tippe-top for several contact radii.
load style

motion = data."/fig12.tsv"
eval panel("fig12", 860, 470)
set lmargin at screen 0.075; set rmargin at screen 0.985; set bmargin at screen 0.135; set tmargin at screen 0.965
set xlabel "{/:Italic t} [s]"
set ylabel "{/:Italic θ} [rad]"
set xrange [0:8]; set yrange [0:3.3]
set xtics 1
set ytics ("0" 0, "π/4" pi/4, "π/2" pi/2, "3π/4" 3*pi/4, "π" pi)
set key at 4.6, 1.5 right top spacing 1.2 title "{/:Italic R} [mm]"
plot motion using "t":"1e-3" with lines linecolor rgb grey linewidth 1.1 title "1", \
     motion using "t":"5e-4" with lines linecolor rgb vermilion linewidth 1.4 title "0.5", \
     motion using "t":"1e-4" with lines linecolor rgb blue linewidth 1.2 title "0.1", \
     motion using "t":"2e-5" with lines linecolor rgb purple linewidth 1.2 title "0.02"
