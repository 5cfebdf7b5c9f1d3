# Phase map of inversion: when theta first is pi/2, over contact radius and initial spin; whether the stick touches.
#   gnuplot -e "style='.../style.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" phase_map.gp
load style

map = data."/phase_map.tsv"
least = data."/phase_map_spins.tsv"
eval panel("phase_map", 860, 540)
set lmargin at screen 0.092
set rmargin at screen 0.79
set bmargin at screen 0.125
set tmargin at screen 0.925

# Cells of the grid: their sides lie half-way to the next.
stats map using (log10(column("contact.body.radius"))) name "R" nooutput
stats map using (column("initial.psi_dot")) name "S" nooutput
stats map using (column("initial.psi_dot") == S_min ? 1 : NaN) name "C" nooutput
columns = C_records; rows = R_records / C_records
half = 10**((R_max - R_min) / (columns - 1) / 2)
up = (S_max - S_min) / (rows - 1) / 2

set logscale x
set logscale cb
set xrange [10**R_min / half:10**R_max * half]
set yrange [S_min - up:S_max + up]
set cbrange [0.5:8]
set xtics ('10^{−6}' 1e-6, '10^{−5}' 1e-5, '10^{−4}' 1e-4, '10^{−3}' 1e-3) out
set ytics 50 out
unset mxtics
set cbtics (0.5, 1, 2, 4, 8)
set xlabel '{/:Italic R} [m]'
set ylabel 'initial spin [rad/s]' offset 2.2, 0
set cblabel '{/:Italic t} where {/:Italic θ} = π/2 [s]' offset 0.6, 0
set palette defined (0 '#2c7fb8', 0.5 '#7fcdbb', 1 '#ffffcc')
set colorbox user origin screen 0.815, 0.40 size screen 0.026, 0.525

none = '#d4d4d4'
set object 1 rectangle from screen 0.815, 0.30 to screen 0.841, 0.335 fillcolor rgb none fillstyle solid border linecolor rgb grey front
set label 1 "not within 8 s" at screen 0.852, 0.3175 left font ',13'
set object 2 circle at screen 0.828, 0.265 size screen 0.0022 fillcolor rgb ink fillstyle solid noborder front
set label 2 "the stick touches" at screen 0.852, 0.265 left font ',13'
set style textbox opaque fillcolor rgb '#ffffff' noborder margins 0.4, 0.3
set label 3 "LG03 5.4" at 5e-4 * 1.2, 180 left front boxed font ',13'
set label 4 "+" at 5e-4, 180 center front font ',20'
set label 11 "dashed: the least spin\nthat could, by Jellet’s\nintegral, if sliding\nalone took energy" at screen 0.815, 0.215 left font ',13'
set label 12 "onto its side" at first 1.1e-6, first 57.5 left front font ',13'
set label 13 "onto its stick" at first 1.1e-6, first 98.5 left front font ',13'

inverted(value) = strcol("inversion") ne "nan" ? value : NaN
touches(value) = strcol("stick") ne "nan" ? value : NaN

set object 3 rectangle from graph 0, 0 to graph 1, 1 fillcolor rgb none fillstyle solid noborder behind
plot map using (inverted(column("contact.body.radius"))):"initial.psi_dot":(column("contact.body.radius") / half):(column("contact.body.radius") * half):(column("initial.psi_dot") - up):(column("initial.psi_dot") + up):(column("inversion")) with boxxyerror fillstyle solid noborder fillcolor palette, \
     map using (touches(column("contact.body.radius"))):"initial.psi_dot" with points pointtype 7 pointsize 0.22 linecolor rgb ink, \
     least using (10**R_min / half):"psi_dot":(10**R_max * half - 10**R_min / half):(0) with vectors nohead linewidth 1.6 dashtype (6,4) linecolor rgb ink
