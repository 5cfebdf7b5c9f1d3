# Figure 8: the Euler angles of the tippe-top.
load style

on(curve, value) = strcol("curve") eq curve ? value : NaN
is(line, value) = strcol("line") eq line ? value : NaN
place(point, value) = strcol("point") eq point ? value : NaN

eval panel("fig08", 600, 454)
unset border; unset tics
set size ratio -1
set margins 0, 0, 0, 0
set xrange [-1.5:1.5]
set yrange [-0.85:1.42]
curves = data."/fig08_curves.tsv"; lines = data."/fig08_lines.tsv"; places = data."/fig08.tsv"

fill(name, colour) = sprintf("curves using (on('%s', column('x'))):'y' with filledcurves closed fillcolor rgb '%s' fillstyle transparent solid 0.55 noborder", name, colour)
outline(name, width) = sprintf("curves using (on('%s', column('x'))):'y' with lines linestyle 3 linewidth %g", name, width)
angle(name, colour) = sprintf("curves using (on('%s', column('x'))):'y' with lines linecolor rgb '%s' linewidth 2", name, colour)
arrow(name, colour, width) = sprintf("lines using (is('%s', column('x'))):'y':'dx':'dy' with vectors head filled size screen 0.022,18 linecolor rgb '%s' linewidth %g", name, colour, width)
text(name, label, colour) = sprintf("places using (place('%s', column('x'))):'y':(\"%s\") with labels center textcolor rgb '%s'", name, label, colour)

eval "plot ".fill('tilted_below', '#f6dcc8').", ".outline('tilted_below', 1.0)." dashtype (5,3), ".\
  fill('level', pale_blue).", ".outline('level', 1.4).", ".\
  fill('tilted_above', '#f6dcc8').", ".outline('tilted_above', 1.4).", ".\
  "lines using (is('nodes', column('x'))):'y':'dx':'dy' with vectors nohead linecolor rgb grey linewidth 1 dashtype (8,3,1.5,3), ".\
  arrow('e1_1', blue, 1.6).", ".arrow('e2_1', blue, 1.6).", ".arrow('e3_1', blue, 1.6).", ".\
  arrow('e2_2', green, 1.6).", ".arrow('e2_3', purple, 1.6).", ".arrow('e1_2', green, 2).", ".\
  arrow('e1_4', vermilion, 1.6).", ".arrow('e2_4', vermilion, 1.6).", ".arrow('e3_4', vermilion, 1.6).", ".\
  angle('phi', green).", ".angle('theta', purple).", ".angle('psi', vermilion).", ".\
  text('e1_1', '{/:Bold e}@_1^1', blue).", ".text('e2_1', '{/:Bold e}@_2^1', blue).", ".\
  text('e3_1', '{/:Bold e}@_3^1 = {/:Bold e}@_3^2', blue).", ".\
  text('e1_2', '{/:Bold e}@_1^2 = {/:Bold e}@_1^3', green)." offset 2.2,-0.1, ".text('e2_2', '{/:Bold e}@_2^2', green).", ".\
  text('e2_3', '{/:Bold e}@_2^3', purple).", ".\
  text('e1_4', '{/:Bold e}@_1^4', vermilion).", ".text('e2_4', '{/:Bold e}@_2^4', vermilion).", ".\
  text('e3_4', '{/:Bold e}@_3^4 = {/:Bold e}@_3^3', vermilion).", ".\
  text('phi', '{/:Italic φ}', green).", ".text('theta', '{/:Italic θ}', purple).", ".text('psi', '{/:Italic ψ}', vermilion)
