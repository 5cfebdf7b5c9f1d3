# One style for every figure. Loaded first by each script, which is called with
#   gnuplot -e "style='.../style.gp'; mesh='.../common/mesh.gp'; data='FOLDER OF TABLES'; figures='FOLDER OF DRAWINGS'" figNN.gp
set encoding utf8
set datafile separator tab
set datafile commentschars '#'
set minussign

# One panel, one file: a page can set panels side by side or, on a narrow screen, below each other.
# A generic font family, so that the drawing looks alike in every browser.
panel(name, width, height) = sprintf("set terminal svg enhanced fixed size %d,%d font 'sans-serif,15' dashlength 0.8 background '#ffffff'; set output '%s/%s.svg'", width, height, figures, name)

# Colour-blind-safe palette (Okabe and Ito 2008), dark enough on white; dashes carry the meaning, as in the paper.
ink       = '#1a1a1a'
grey      = '#7a7a7a'
blue      = '#0072b2'
vermilion = '#d55e00'
green     = '#007a5a'
purple    = '#8a4f9e'
pale_blue = '#dcebf5'
mesh_blue = '#2b5f80'

set style line 1 linecolor rgb blue      linewidth 2.4                  # uniform pressure: solid
set style line 2 linecolor rgb vermilion linewidth 2.4 dashtype (8,5)   # Hertz ("parabolic") pressure: dashed
set style line 3 linecolor rgb ink       linewidth 2.6                  # sets
set style line 4 linecolor rgb vermilion linewidth 1.6                  # formulas as printed
set style line 8 linecolor rgb grey      linewidth 1.0 dashtype (2,3)   # guides, asymptotes
set style line 9 linecolor rgb ink       linewidth 1.0                  # construction lines
# Families of curves, from the sharpest to the smoothest.
set style line 11 linecolor rgb blue      linewidth 2.2
set style line 12 linecolor rgb green     linewidth 2.2
set style line 13 linecolor rgb vermilion linewidth 2.2
set style line 14 linecolor rgb purple    linewidth 2.2
set style arrow 1 head filled size screen 0.022,18 linestyle 9
set style arrow 2 head filled size screen 0.026,18 linecolor rgb blue linewidth 2.2

set border linewidth 1 linecolor rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set key noautotitle textcolor rgb ink
set samples 400

# The frame of a plane panel; gnuplot's own estimate of text widths leaves too much room in SVG.
set lmargin at screen 0.165
set rmargin at screen 0.965
set bmargin at screen 0.180
set tmargin at screen 0.965
set xlabel offset 0, 0.4
set ylabel offset 1.8, 0

# The frame of a panel in space: the view's scale sets the size.
space = "unset lmargin; unset rmargin; unset bmargin; unset tmargin; set xlabel offset 0, 0; set ylabel offset 0, 0"
