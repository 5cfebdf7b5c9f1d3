# Figure 7: geometry of the tippe-top, to scale.
load style

on(curve, value) = strcol("curve") eq curve ? value : NaN
is(line, value) = strcol("line") eq line ? value : NaN
place(point, value) = strcol("point") eq point ? value : NaN

stick_blue = '#c3dcec'
set style arrow 3 head filled size screen 0.020,18 linestyle 9                        # a direction, a radius
set style arrow 4 heads filled size screen 0.016,18 linecolor rgb blue linewidth 1.3  # a distance
set style line 20 linecolor rgb grey linewidth 1.0 dashtype (8,3,1.5,3)               # axis of symmetry
set style line 21 linecolor rgb grey linewidth 0.8                                    # extension lines
set style line 22 linecolor rgb mesh_blue linewidth 1 dashtype (4,3)                  # spheres beyond the material

unset border; unset tics
set size ratio -1
set margins 0, 0, 0, 0
top = "curves using (on('body', column('x'))):'y' with filledcurves closed fillcolor rgb pale_blue fillstyle solid noborder, \
       curves using (on('stick', column('x'))):'y' with filledcurves closed fillcolor rgb stick_blue fillstyle solid noborder, \
       curves using (on('body', column('x'))):'y' with lines linestyle 3 linewidth 1.8, \
       curves using (on('stick', column('x'))):'y' with lines linestyle 3 linewidth 1.8, \
       curves using (on('construction_body', column('x'))):'y' with lines linestyle 22, \
       curves using (on('construction_tip', column('x'))):'y' with lines linestyle 22, \
       lines using (is('extension', column('x'))):'y':'dx':'dy' with vectors nohead linestyle 21, \
       lines using (is('axis', column('x'))):'y':'dx':'dy' with vectors nohead linestyle 20, \
       lines using (is('floor', column('x'))):'y':'dx':'dy' with vectors nohead linestyle 3"

# (a) inclined, above the floor
eval panel("fig07a", 640, 500)
set xrange [-28:36]
set yrange [-5:45]
curves = data."/fig07a_curves.tsv"; lines = data."/fig07a_lines.tsv"; places = data."/fig07a.tsv"
set object 1 rectangle from -27,-1.3 to 35,0 fillcolor rgb '#e4e4e4' fillstyle solid noborder behind
set label 1 "10 mm" at -16.4,-3.6 left
set arrow 1 from -27,-3.6 to -17,-3.6 heads size screen 0.008,90 linestyle 9
arrow(name) = sprintf("lines using (is('%s', column('x'))):'y':'dx':'dy' with vectors arrowstyle", name)
text(name, label) = sprintf("places using (place('%s', column('x'))):'y':(\"%s\") with labels", name, label)
middle(name, label) = sprintf("lines using (is('%s', column('x')) + 0.5*column('dx')):(column('y') + 0.5*column('dy')):(\"%s\") with labels", name, label)
end(name, label) = sprintf("lines using (is('%s', column('x')) + column('dx')):(column('y') + column('dy')):(\"%s\") with labels", name, label)
eval "plot ".top.", ".\
  "lines using (is('vertical', column('x'))):'y':'dx':'dy' with vectors nohead linestyle 9, ".\
  "curves using (on('theta', column('x'))):'y' with lines linestyle 9, ".\
  arrow('e3_4')." 3, ".arrow('e3_1')." 3, ".arrow('e2_1')." 3, ".arrow('r1')." 3, ".arrow('r2')." 3, ".\
  arrow('a1')." 4, ".arrow('a2')." 4, ".arrow('g_n1')." 4, ".arrow('g_n2')." 4, ".arrow('z_s')." 4, ".\
  "places using (strcol('point') eq 'theta' ? NaN : column('x')):'y' with points pointtype 7 pointsize 0.45 linecolor rgb ink, ".\
  text('S', '{/:Italic S}')." left offset 0.5,-0.5, ".\
  text('M', '{/:Italic M}')." left offset 0.6,0.4, ".\
  text('N', '{/:Italic N}')." left offset 0.3,0.7, ".\
  text('C', '{/:Italic C}')." right offset -0.6,-0.3, ".\
  text('M_floor', "{/:Italic M'}")." center offset 0,-0.9, ".\
  text('theta', '{/:Italic θ}')." center offset -0.2,0.8, ".\
  end('e3_4', '{/:Bold e}@_3^4')." right offset -0.6,0.2, ".\
  end('e3_1', '{/:Bold e}@_3^1')." left offset 0.5,0.2, ".\
  end('e2_1', '{/:Bold e}@_2^2')." right offset 0.4,0.9, ".\
  "places using (place('O', column('x'))):'y' with points pointtype 6 pointsize 1.5 linewidth 1.2 linecolor rgb ink, ".\
  text('O', '{/:Bold e}@_1^2')." right offset -1.0,0.7, ".\
  middle('a1', '{/:Italic a}_1')." textcolor rgb blue right offset -0.5,0, ".\
  middle('a2', '{/:Italic a}_2')." textcolor rgb blue left offset 0.5,0.4, ".\
  middle('r1', '{/:Italic r}_1')." center offset 0.4,0.8, ".\
  middle('r2', '{/:Italic r}_2')." center offset 0.4,0.7, ".\
  middle('g_n1', '{/:Italic g}_{/:Italic N}_1')." textcolor rgb blue left offset 0.5,0, ".\
  middle('g_n2', '{/:Italic g}_{/:Italic N}_2')." textcolor rgb blue left offset 0.5,0, ".\
  middle('z_s', '{/:Italic z}_{/:Italic S}')." textcolor rgb blue right offset -0.5,0"

# (b) upright on the body, upright on the stick
eval panel("fig07b", 640, 300)
set xrange [-26:65]
set yrange [-7:35.6]
curves = data."/fig07b_curves.tsv"; lines = data."/fig07b_lines.tsv"; places = data."/fig07b.tsv"
set object 1 rectangle from -25,-1.3 to 64,0
unset label 1; unset arrow 1
eval "plot ".top.", ".arrow('h')." 4, ".\
  "places using (strcol('point') eq 'S' || strcol('point') eq 'M' || strcol('point') eq 'N' ? column('x') : NaN):'y' with points pointtype 7 pointsize 0.45 linecolor rgb ink, ".\
  text('S', '{/:Italic S}')." left offset 0.6,0, ".\
  text('M', '{/:Italic M}')." left offset 0.6,0, ".\
  text('N', '{/:Italic N}')." left offset 0.6,0, ".\
  text('h trivial', '{/:Italic h} = {/:Italic r}_1 − {/:Italic a}_1')." textcolor rgb blue rotate by 90 center offset -1.5,0, ".\
  text('h inverted', '{/:Italic h} = {/:Italic r}_2 + {/:Italic a}_2')." textcolor rgb blue rotate by 90 center offset -1.5,0, ".\
  text('trivial', '{/:Italic θ} = 0')." center offset 0,-1.2, ".\
  text('inverted', '{/:Italic θ} = π')." center offset 0,-1.2"
