# Figure 11: Magnus's stability diagram: closed form, roots, simulation.
load style

eval panel("fig11", 860, 470)
set lmargin at screen 0.095
set rmargin at screen 0.975
set bmargin at screen 0.145
set tmargin at screen 0.915
set xrange [0:5]; set yrange [0:2]
set xtics 1; set ytics 0.5
set xlabel "{/:Italic h}/{/:Italic r}"
set ylabel "{/:Italic I}_3/{/:Italic I}_1" offset 2.2, 0

borders = data."/fig11.tsv"; roots = data."/fig11_roots.tsv"
positions = data."/fig11_positions.tsv"; simulated = data."/fig11_simulated.tsv"
of(region, value) = strcol("region") eq region ? value : NaN
on(line, value) = strcol("line") eq line ? value : NaN
said(value) = strcol("top") eq "of this shape" && column("agrees") == 1 ? value : NaN
not_said(value) = strcol("top") eq "of this shape" && column("agrees") == 0 ? value : NaN
drilled(value) = strcol("top") eq "of this shape" && column("agrees_drilling") == 0 ? value : NaN

array regions = ["I", "II", "III", "IV"]
array colour = ['#f6dccb', '#d3eae1', pale_blue, '#eadff0']
set label 1 "I" at 1.6, 0.26 center font ",22" front
set label 2 "II" at 3.15, 1.53 center font ",22" front
set label 3 "III" at 0.775, 1.53 center font ",22" front
set label 4 "IV" at 0.17, 1.02 center font ",22" front
set label 5 "trivial" at 0.63, 0.775 center front
set label 6 "inverted" at 4.2, 0.79 center front
set label 7 "{/:Italic h}/{/:Italic r} = 1" at 1.0, 2.06 center front
set label 8 "{/:Italic h}/{/:Italic r} = {/:Italic I}_1/{/:Italic I}_3" at 0.49, 2.06 center front
set label 9 "dot: simulation agrees;  ring: not with drilling torque" at 5, 2.06 right textcolor rgb grey font ",13" front

plot for [k = 1:4] roots using (of(regions[k], column("h_over_r"))):"i3_over_i1":(0.045):(0.045) with boxxyerror fillstyle solid noborder fillcolor rgb colour[k], \
     borders using (on("a = 0", column("h_over_r"))):"i3_over_i1" with lines linestyle 3, \
     borders using (on("hyperbola", column("h_over_r"))):"i3_over_i1" with lines linestyle 3, \
     simulated using (said(column("h_over_r"))):"i3_over_i1" with points pointtype 7 pointsize 0.75 linecolor rgb ink, \
     simulated using (not_said(column("h_over_r"))):"i3_over_i1" with points pointtype 2 pointsize 1.2 linewidth 2 linecolor rgb vermilion, \
     simulated using (drilled(column("h_over_r"))):"i3_over_i1" with points pointtype 6 pointsize 1.25 linewidth 1.6 linecolor rgb grey, \
     positions using "h_over_r":"i3_over_i1" with points pointtype 5 pointsize 1.2 linecolor rgb vermilion, \
     positions using "h_over_r":"i3_over_i1" with points pointtype 4 pointsize 1.25 linewidth 1.6 linecolor rgb ink
