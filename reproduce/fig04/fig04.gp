# Figure 4: the friction ball B_F, uniform pressure.
load style

call mesh data."/fig04.tsv" "meridian" "lambda_t1" "lambda_t2" "lambda_tau"

eval panel("fig04", 480, 335)
eval space
set origin 0,0.075  # the box of the axes leaves more room above than below
set view 66, 34, 1.74
set view equal xyz
set xyplane at -0.8
set xrange [-1.1:1.1]; set yrange [-1.1:1.1]; set zrange [-0.8:0.8]
set xtics -1,1,1 offset 0,-0.3; set ytics -1,1,1 offset 0.4,-0.2; set ztics ("−2/3" -2.0/3, "0" 0, "2/3" 2.0/3)
set xlabel "{/:Italic λ}_{/:Italic T}_1/({/:Italic μλ_N})" offset 3,1.0
set ylabel "{/:Italic λ}_{/:Italic T}_2/({/:Italic μλ_N})" offset -7.2,0.6
set label 1 "{/:Italic λ_τ}/({/:Italic μλ_N})" at -1.1,-1.1,1.0 center
set border 31 linewidth 0.6
set palette defined (0 '#dcebf5', 1 '#5aa2cf')
unset colorbox
set pm3d depthorder border linecolor rgb '#2b5f80' linewidth 0.4
set multiplot
splot $mesh using 1:2:3 with pm3d
# The printed meridians that face the reader: on top, for pm3d would sort them into its own patches.
unset xtics; unset ytics; unset ztics; unset xlabel; unset ylabel; unset label; set border 0
set label 2 "(2.19)" at screen 0.79,0.83 left textcolor rgb vermilion front
splot for [m = 30:48:6] data."/fig04_printed.tsv" using (column("meridian") == m ? column("lambda_t1") : NaN):"lambda_t2":"lambda_tau" with lines linestyle 4
unset multiplot
