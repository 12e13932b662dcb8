# Critical step against how far the body's end is into a fresh cell; and the least of each method.
tall = 1.25
load plots.'/style.gp'
points_ = dir.'/'.name.'.points.csv'
omega_ = dir.'/'.name.'.omega.csv'

list_ = points_
load plots.'/methods.gp'
small = fmt eq 'png' ? ',14' : ',9'

set multiplot
set lmargin at screen 0.105
set rmargin at screen 0.56
set bmargin at screen 0.1
set tmargin at screen 0.88
set logscale xy
set format x '10^{%T}'
set xrange [7e-5:0.15]
set yrange [0.009:2]
set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2)
set xlabel 'ε/h, depth of the last particle in a fresh cell (1D)'
set ylabel 'largest stable Δt c/h'
set label 1 heading('A node that is hardly touched, cd') at graph 0, graph 1.09
set label 2 'GE-MPM: 2 (ε/h)^{1/2} = 2/ω_{max}' at 0.0018, 0.026 left font small textcolor rgb COLOUR[style('ge_mpm')]
set label 3 'MPM: (2ε/h)^{1/2}' at 0.0018, 0.0205 left font small textcolor rgb COLOUR[style('mpm')]
set label 4 'WLS: its surface so deep' at 0.0018, 0.0162 left font small textcolor rgb COLOUR[style('wls')]
set key off
touched_(m, e) = strcol('method') eq m && strcol('edge') eq e && column('dim') == 1 && column('critical') > 0 ? column('depth') : NaN
plot 2 * sqrt(x) with lines ls 20, sqrt(2 * x) with lines ls 21, \
     for [m in seen_] points_ using (touched_(m, 'particle')):'critical' with linespoints ls style(m), \
     points_ using (touched_('wls', 'box')):'critical' with linespoints ls style('wls') dt 2

unset logscale
unset label
set lmargin at screen 0.7
set rmargin at screen 0.985
set format x '%g'
set logscale x
set xrange [0.009:1.5]
set xtics (0.01, 0.03, 0.1, 0.3, 1)
n_ = words(seen_)
set yrange [n_ - 0.5:-0.5]
set ytics ()
do for [k = 1:n_] { set ytics add (label(word(seen_, k)) k - 1) }
unset ylabel
set xlabel 'largest stable Δt c/h'
set label 1 heading('All ways to touch it') at graph 0, graph 1.09
set grid ytics xtics
set key at screen 0.985, screen 0.915 right top maxrows 1 font small samplen 0.5
plot points_ using (column('dim') == 1 && column('critical') > 0 ? column('critical') : NaN):(at_(strcol('method')) - 0.15) with points pt 7 ps 0.9 lc rgb VARIANT[1] title '1D', \
     points_ using (column('dim') == 2 && column('critical') > 0 ? column('critical') : NaN):(at_(strcol('method')) + 0.05) with points pt 6 ps 1 lw 1.4 lc rgb VARIANT[3] title '2D', \
     points_ using (column('grows_below') > 0 ? column('grows_below') : NaN):(at_(strcol('method')) + 0.25) with points pt 2 ps 0.8 lw 1.2 lc rgb '#555555' title 'grows below'
unset multiplot
