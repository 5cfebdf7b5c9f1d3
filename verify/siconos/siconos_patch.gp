# The patch cut into N points: what Siconos finds for them against our solution with four rows; and the ball of N points.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" siconos_patch.gp
load style
light = '#dedede'
patch = data . '/siconos_patch.tsv'
ball  = data . '/siconos_ball.tsv'
eval panel('siconos_patch', 940, 900)

set logscale xy
set grid xtics ytics linecolor rgb light linewidth 0.6

# Columns of siconos_patch: 1 pressure, 2 set, 3 motion, 4 points, 5 error; of siconos_ball: 1 pressure, 2 set, 3 points, 4 error.
of(p, s, m) = strcol(1) eq p && strcol(2) eq s && strcol(3) eq m ? column(5) : NaN
ball_of(p, s) = strcol(1) eq p && strcol(2) eq s ? column(4) : NaN

array motion = ['sliding', 'turning', 'spinning', 'sticking']
array text = ['sliding, {/:Italic u} = 2', 'turning, {/:Italic u} = ½', 'spinning, {/:Italic u} = 0', 'sticking']
array colour = [blue, vermilion, green, purple]

set multiplot
do for [row = 1:2] {
  do for [col = 1:2] {
    pressure = col == 1 ? 'uniform' : 'hertz'
    set lmargin at screen (col == 1 ? 0.092 : 0.552)
    set rmargin at screen (col == 1 ? 0.497 : 0.957)
    set bmargin at screen (row == 1 ? 0.410 : 0.080)
    set tmargin at screen (row == 1 ? 0.955 : 0.340)
    set xlabel (row == 2 ? 'number of points {/:Italic N}' : '') offset 0,0.3
    set title (row == 1 ? (col == 1 ? 'Uniform pressure' : 'Hertz pressure') : '') offset 0,-0.6
    unset label
    set format y (col == 1 ? '10^{%T}' : '')
    if (row == 1) {
      set xrange [3:700]
      set xtics (4, 16, 64, 256)
      set yrange [1e-16:1]
      set ytics 1e-15,1e3,1
      set ylabel (col == 1 ? 'force or velocity, Siconos against ours' : '') offset 1.5,0
      set key at graph 0.03,0.03 left bottom Left reverse samplen 2 spacing 1.05 font ',13'
      set label '{/:Italic N}^{ −1}' at 330,0.5/100 left textcolor rgb grey
      plot [4:600] 0.5/x with lines linestyle 8, \
        for [i = 1:4] patch using 4:(of(pressure, 'sunflower', motion[i])) with linespoints linecolor rgb colour[i] \
          linewidth 1.4 dashtype (6,4) pointtype 6 pointsize 0.7, \
        for [i = 1:4] patch using 4:(of(pressure, 'rings', motion[i])) with linespoints linecolor rgb colour[i] \
          linewidth 2.2 pointtype 7 pointsize 0.7 title (col == 1 ? text[i] : ''), \
        NaN with linespoints linecolor rgb ink linewidth 2.2 pointtype 7 pointsize 0.7 title (col == 2 ? 'rings' : ''), \
        NaN with linespoints linecolor rgb ink linewidth 1.4 dashtype (6,4) pointtype 6 pointsize 0.7 \
          title (col == 2 ? 'sunflower' : '')
    } else {
      set xrange [3:60000]
      set xtics (4, 64, 1024, 16384)
      set yrange [3e-8:1]
      set ytics 1e-8,1e2,1
      set ylabel (col == 1 ? 'distance of the balls' : '') offset 1.5,0
      set label '{/:Italic N}^{ −1}' at 2.2e4,8e-5 right textcolor rgb grey
      set label '{/:Italic N}^{ −3/2}' at 3e3,1.6e-7 right textcolor rgb grey
      plot [4:40000] 0.5/x with lines linestyle 8, 0.25*x**-1.5 with lines linestyle 8, \
        ball using 3:(ball_of(pressure, 'sunflower')) with linespoints linecolor rgb ink linewidth 1.4 dashtype (6,4) \
          pointtype 6 pointsize 0.7, \
        ball using 3:(ball_of(pressure, 'rings')) with linespoints linecolor rgb ink linewidth 2.2 pointtype 7 pointsize 0.7
    }
  }
}
unset multiplot
