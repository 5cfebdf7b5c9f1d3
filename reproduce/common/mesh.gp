# call mesh "TABLE" "LINE" "X" "Y" "Z": fills the datablock $mesh with columns X Y Z of TABLE, for splot.
# gnuplot tells the mesh lines of a surface apart by blank lines; our tables have none, but a column LINE that numbers them.
set table $points separator tab
plot ARG1 using (sprintf("%.17g\t%.17g\t%.17g\t%.17g", column(ARG2), column(ARG3), column(ARG4), column(ARG5))) with table
unset table
set print $mesh
do for [i = 1:|$points|] {
  if (i > 1 && word($points[i], 1) ne word($points[i - 1], 1)) { print "" }
  print sprintf("%s\t%s\t%s", word($points[i], 2), word($points[i], 3), word($points[i], 4))
}
unset print
