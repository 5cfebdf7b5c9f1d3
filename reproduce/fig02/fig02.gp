# Figure 2: the velocity potential Φ as a function of v and ωR, uniform pressure.
load style

# (a) the cone
call mesh data."/fig02a.tsv" "phi" "v" "omega_r" "phi"

eval panel("fig02a", 480, 450)
eval space
set origin 0,0.02
set view 64, 32, 1.06, 1.4
set xyplane at 0
set xrange [-1.6:1.6]; set yrange [-1.6:1.6]; set zrange [0:1]

set xtics -1,1,1 offset 0,-0.3; set ytics -1,1,1 offset 0.4,-0.2; set ztics 0,0.5,1
set xlabel "{/:Italic v} [m/s]" offset 0.6,0.1
set ylabel "{/:Italic ωR} [m/s]" offset -3.4,0.4
set label 1 "Φ/({/:Italic μλ_N}) [m/s]" at -1.6,-1.6,1.16 center
set border 31 linewidth 0.6
set palette defined (0 '#f2f7fb', 1 '#5aa2cf')
unset colorbox
set pm3d depthorder border linecolor rgb '#2b5f80' linewidth 0.5
splot $mesh using 1:2:3 with pm3d

# (b) contour lines, and the two shapes the paper names, of the same width and height as the last contour.
reset
load style
eval panel("fig02b", 440, 450)
set size ratio -1
set xrange [-1.85:1.85]; set yrange [-1.85:1.85]
set xtics 0.5; set ytics 0.5
set xlabel "{/:Italic v} [m/s]"
set ylabel "{/:Italic ωR} [m/s]"
set zeroaxis linestyle 8
set label 1 "0.25" at 0, 0.375 center offset 0,0.5 front
set label 2 "0.5"  at 0, 0.75 center offset 0,0.5 front
set label 3 "0.75" at 0, 1.125 center offset 0,0.5 front
set label 4 "Φ/({/:Italic μλ_N}) = 1 m/s" at 0, 1.5 center offset 0,0.8 front

set parametric
set trange [0:2*pi]
level(c) = (column("phi") == c ? column("v") : NaN)
file = data."/fig02b.tsv"
plot cos(t), 1.5*sin(t) with lines linestyle 8, \
     '-' using 1:2 with lines linestyle 8, \
     for [c in "0.25 0.5 0.75 1"] file using (level(c+0)):"omega_r" with lines linestyle 1
-1	-1.5
1	-1.5
1	1.5
-1	1.5
-1	-1.5
e
