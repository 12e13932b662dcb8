# Large deformation: errors against the mesh at half amplitude, and a grid of who survives what.
tall = 1.35
load plots.'/style.gp'
errors_ = dir.'/'.name.'.errors.csv'
grid_ = dir.'/'.name.'.grid.csv'
stats grid_ using 'line' nooutput
lines_ = STATS_max + 1
array NAMES[lines_]
rule(r) = r eq 'stretch' ? ', U' : r eq 'undeformed' ? ', l_0' : ''
stats grid_ using (NAMES[int(column('line')) + 1] = label(strcol('method')).rule(strcol('rule')), 1) nooutput
set datafile missing NaN
small = fmt eq 'png' ? ',15' : ',10'
set multiplot
of(m, r, s) = strcol('method') eq m && strcol('rule') eq r && strcol('status') eq s ? column('cells') : NaN
set lmargin at screen 0.075
set rmargin at screen 0.41
set tmargin at screen 0.9
set bmargin at screen 0.33
set logscale xy
set xrange [7:27]
set xtics (8, 12, 16, 24)
set yrange [1e-2:3]
set format y '10^{%T}'
set xlabel 'cells per metre, N'
set label 1 heading('Vortex, G = .5: largest error [m]') at graph 0, graph 1.04
set label 3 'U: half widths follow the stretch; l_0: they stay' at screen 0.015, screen 0.065 font small
set key at screen 0.01, screen 0.245 left top maxrows 7 samplen 1.6 width -2 font small
plot for [m in METHODS] errors_ using (of(m, 'fxx', 'ok')):'error' with linespoints ls style(m) title label(m), \
     for [m in METHODS] errors_ using (of(m, 'fxx', 'lost')):(2.7 * 0.9**place(m)) with points ls style(m) pt 1 ps 1.2 notitle, \
     for [m in 'gimp ge_gimp'] errors_ using (of(m, 'stretch', 'ok')):'error' with linespoints ls style(m) dt 2 title label(m).', U', \
     for [m in 'gimp ge_gimp'] errors_ using (of(m, 'undeformed', 'ok')):'error' with linespoints ls style(m) dt 3 title label(m).', l_0', \
     NaN with points pt 1 lc rgb '#444444' title 'lost'

unset logscale
unset key
unset xlabel
unset label
set format y '%g'
array SHADE[4] = [0xd7ecd9, 0xf6efcf, 0xf7d9b5, 0xf0b8b0]
array MEANING[4] = ['largest error at most .03 m (bar: ok)', 'at most .1 m', 'more', 'lost']
set lmargin at screen 0.56
set rmargin at screen 0.99
set bmargin at screen 0.12
set tmargin at screen 0.89
set xrange [-0.5:4.5]
set yrange [lines_ - 0.5:-0.5]
unset grid
set border 0
set tics scale 0
unset xtics
set x2tics ('G = .1' 0, '.25' 1, '.5' 2, '1' 3, 'bar' 4)
set x2range [-0.5:4.5]
set label 1 heading('Vortex, N = 24, by amplitude; hanging bar, N = 16') at graph -0.28, graph 1.085
set ytics ()
do for [k = 1:lines_] { set ytics add (NAMES[k] k - 1) }
set style fill solid 1 border rgb '#ffffff'
set key at screen 0.45, screen 0.1 left top maxrows 2 width -8 samplen 1.5 font small
plot grid_ using 'column':'line':(0.49):(0.47):(SHADE[int(column('grade')) + 1]) with boxxyerror \
         lc rgb variable notitle, \
     grid_ using 'column':'line':(strcol('text')) with labels noenhanced font sprintf(',%d', fmt eq 'png' ? 13 : 9) notitle, \
     for [k = 1:4] NaN with points pt 5 ps 2.5 lc rgb SHADE[k] title MEANING[k]
unset multiplot
