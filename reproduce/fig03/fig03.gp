# Figure 3: admissible forces, uniform pressure.
load style

# (a) the friction disk
eval panel("fig03a", 440, 450)
set size ratio -1
set xrange [-1.25:1.25]; set yrange [-1.25:1.25]
set xtics 0.5; set ytics 0.5
set zeroaxis linestyle 8
set xlabel "{/:Italic λ}_{/:Italic T}_1/({/:Italic μλ_N})"
set ylabel "{/:Italic λ}_{/:Italic T}_2/({/:Italic μλ_N})"
set label 1 "{/:Italic D_T}" at 0.45, 0.45 center
plot data."/fig03a.tsv" using "lambda_t1":"lambda_t2" with filledcurves closed fillcolor rgb pale_blue fillstyle solid noborder, \
     data."/fig03a.tsv" using "lambda_t1":"lambda_t2" with lines linestyle 1

# (b) the friction plate, with the seam at u = 1 magnified
reset
load style
eval panel("fig03b", 440, 450)
set multiplot
set size ratio -1
set xrange [-1.25:1.25]; set yrange [-1.25:1.25]
set xtics 0.5; set ytics 0.5
set zeroaxis linestyle 8
set xlabel "{/:Italic λ_T}/({/:Italic μλ_N})"
set ylabel "{/:Italic λ_τ}/({/:Italic μλ_N})"
set label 1 "{/:Italic P_F}" at -0.68, 0 center
plate = data."/fig03b.tsv"
printed = data."/fig03b_printed.tsv"
branch(name, value) = strcol("branch") eq name ? value : NaN
# The window magnified in the inset, about u = 1 and the printed ξ* = 55/64.
x0 = 0.838; x1 = 0.874; y0 = 0.256; y1 = 0.292
set object 1 rectangle from x0, y0 to x1, y1 fillstyle empty border rgb grey linewidth 1 front
set arrow 1 from x0, y1 to 0.42, 0.42 nohead linestyle 8 linewidth 0.8 front
set arrow 2 from x0, y0 to 0.42, -0.42 nohead linestyle 8 linewidth 0.8 front
plot plate using "lambda_t":"lambda_tau" with filledcurves closed fillcolor rgb pale_blue fillstyle solid noborder, \
     plate using "lambda_t":"lambda_tau" with lines linestyle 1

unset object; unset arrow; unset label; unset xlabel; unset ylabel; unset zeroaxis
# Where the frame of the inset comes to lie: 0.84 wide in the units of the plate about the origin.
set lmargin at screen 0.431; set rmargin at screen 0.699; set bmargin at screen 0.4406; set tmargin at screen 0.7044
set label 2 "exact" at graph 0.50, 0.72 left textcolor rgb blue front
set label 3 "(2.18)" at graph 0.10, 0.30 left textcolor rgb vermilion front
set object 2 rectangle from graph 0,0 to graph 1,1 fillcolor rgb 'white' fillstyle solid noborder behind
set border 15 linecolor rgb grey
set xrange [x0:x1]; set yrange [y0:y1]
unset xtics; unset ytics
plot plate using "lambda_t":"lambda_tau" with lines linestyle 1, \
     for [b in "inner outer"] printed using (branch(b, column("lambda_t"))):"lambda_tau" with lines linestyle 4
unset multiplot

# (c) projections onto the plate: from a force outside, along the normal
reset
load style
eval panel("fig03c", 440, 450)
set size ratio -1
set xrange [0:1.4]; set yrange [-0.2:1.2]
set xtics 0.5; set ytics 0,0.5,1
set xlabel "{/:Italic λ_T}/({/:Italic μλ_N})"
set ylabel "{/:Italic λ_τ}/({/:Italic μλ_N})"
set yzeroaxis linestyle 8
set xzeroaxis linestyle 8
set label 1 "{/:Italic P_F}" at 0.17, 0.2 center front
points = data."/fig03c.tsv"
outside(x) = column("inside") == 0 ? x : NaN
plot plate using (column("lambda_t")):(column("lambda_tau")) with filledcurves closed fillcolor rgb pale_blue fillstyle solid noborder, \
     plate using "lambda_t":"lambda_tau" with lines linestyle 1, \
     points using (outside(column("lambda_t"))):"lambda_tau":(column("nearest_t") - column("lambda_t")):(column("nearest_tau") - column("lambda_tau")) with vectors arrowstyle 1, \
     points using "lambda_t":"lambda_tau" with points pointtype 7 pointsize 0.55 linecolor rgb ink
