# Figure 1: coordinates at the contact surface.
load style

eval panel("fig01", 480, 460)

unset border; unset tics
set size ratio -1
set margins 0, 0, 0, 0
set xrange [-1.15:1.45]
set yrange [-1.08:1.46]

curves = data."/fig01_curves.tsv"
lines  = data."/fig01_lines.tsv"

# The numbers of the drawing, for placing labels.
stats data."/fig01.tsv" using "x"     nooutput name "X"
stats data."/fig01.tsv" using "y"     nooutput name "Y"
stats data."/fig01.tsv" using "phi"   nooutput name "PHI"
stats data."/fig01.tsv" using "theta" nooutput name "THETA"
stats data."/fig01.tsv" using "pole"  nooutput name "POLE"
x = X_min; y = Y_min; phi = PHI_min; theta = THETA_min; pole = POLE_min

set label 1 "{/:Bold e}_1" at 1.30, 0.0 left offset 0.3,0 front
set label 2 "{/:Bold e}_2" at 0.0, 1.30 center offset 0,0.5 front
set label 3 "{/:Italic R}* {/:Bold e}_2" at 0, pole right offset -0.8,0.2 front
set label 4 "{/:Italic ρ}" at 0.62*x, 0.62*y center offset -0.3,0.7 front
set label 5 "{/:Italic r}" at 0.5*x, (y+pole)/2 left offset 0.1,0.7 front
set label 6 "{/:Italic φ}" at 0.36*cos(phi/2), 0.36*sin(phi/2) center offset 0,0 front
set label 7 "{/:Italic θ}" at 0.27*sin(theta/2), pole-0.27*cos(theta/2) center front
set label 8 "d{/:Italic A}" at x, y left offset 1.0,-0.6 front
set label 9 "{/:Bold γ}_{/:Italic T} = {/:Italic v} {/:Bold e}_1" at 0.5*pole, 0 center offset 0.6,-0.9 front textcolor rgb blue
set label 10 "{/:Italic ω}" at -0.03, 0.18 right front textcolor rgb blue
set label 11 "{/:Italic R}" at 0.6*cos(215*pi/180), 0.6*sin(215*pi/180) center offset -0.4,1.0 front
set label 12 "{/:Bold w}" at x+(pole-y), y+x left offset 0.5,0.3 front textcolor rgb blue

on(curve, value) = strcol("curve") eq curve ? value : NaN
is(line, value) = strcol("line") eq line ? value : NaN

plot curves using (on("disc", column("x"))):"y" with filledcurves closed fillcolor rgb pale_blue fillstyle solid noborder, \
     curves using (on("disc", column("x"))):"y" with lines linestyle 3 linewidth 2, \
     curves using (on("phi", column("x"))):"y" with lines linestyle 9, \
     curves using (on("theta", column("x"))):"y" with lines linestyle 9, \
     curves using (on("element", column("x"))):"y" with filledcurves closed fillcolor rgb ink fillstyle solid noborder, \
     curves using (on("element", column("x"))):"y" with lines linestyle 3 linewidth 1.5, \
     lines using (is("e1", column("x"))):"y":"dx":"dy" with vectors arrowstyle 1, \
     lines using (is("e2", column("x"))):"y":"dx":"dy" with vectors arrowstyle 1, \
     lines using (is("R", column("x"))):"y":"dx":"dy" with vectors arrowstyle 1, \
     lines using (is("rho", column("x"))):"y":"dx":"dy" with vectors nohead linestyle 9, \
     lines using (is("r", column("x"))):"y":"dx":"dy" with vectors nohead linestyle 9, \
     lines using (is("v", column("x"))):"y":"dx":"dy" with vectors arrowstyle 2, \
     lines using (is("w", column("x"))):"y":"dx":"dy" with vectors head filled size screen 0.026,18 linecolor rgb blue linewidth 2.2, \
     curves using (on("omega", column("x"))):"y" with lines linecolor rgb blue linewidth 2.2, \
     lines using (is("omega", column("x"))):"y":"dx":"dy" with vectors head filled size screen 0.026,18 linecolor rgb blue linewidth 2.2, \
     data."/fig01.tsv" using (0):"pole" with points pointtype 7 pointsize 0.6 linecolor rgb ink
